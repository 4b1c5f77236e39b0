#!/usr/bin/env bash
# Runs the tests with a real window again and again while as many other processes as there are processors keep them busy:
# what fails here fails by load. By hand, when nothing else runs:
#   tests/under_load.sh [TIMES=20] [FILTER='RealWindow*'] [PROGRAM=build/release/tests/app_tests]
set -euo pipefail
cd "$(dirname "$0")/.."
times="${1:-20}" filter="${2:-RealWindow*}" program="${3:-build/release/tests/app_tests}"

for ((i = 0; i < $(nproc); ++i)); do
  (while :; do :; done) &
done
trap 'kill $(jobs -p)' EXIT

failed=0
for ((run = 1; run <= times; ++run)); do
  result=passed
  "$program" --gtest_brief=1 --gtest_filter="$filter" || { result=FAILED; failed=$((failed + 1)); }
  echo "run $run of $times: $result after $SECONDS s"
done
echo "$failed of $times runs failed"
[ "$failed" -eq 0 ]
