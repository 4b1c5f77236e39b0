#!/usr/bin/env python3
"""Holds JSON files against a JSON Schema: validate.py SCHEMA FILE...  For each file a line, "valid" or what is wrong."""

import json
import sys

import jsonschema


def load(name):
    with open(name, encoding="utf-8") as file:
        return json.load(file)


schema = load(sys.argv[1])
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
for name in sys.argv[2:]:
    error = jsonschema.exceptions.best_match(validator.iter_errors(load(name)))
    print("valid" if error is None else error.json_path + ": " + error.message.splitlines()[0])
