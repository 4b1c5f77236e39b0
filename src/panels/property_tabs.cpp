#include "panels/property_tabs.h"

namespace anamorph {
namespace {

PropertyTab tabOf(const Selection& selection, PropertyTab otherwise) {
  switch (selection.part) {
    case Part::eye:
    case Part::aim:
      return PropertyTab::eye;
    case Part::original:
      return PropertyTab::original;
    case Part::mirror:
    case Part::controlPoint:
      return PropertyTab::mirror;
    case Part::sculpture:
      return PropertyTab::sculpture;
    case Part::light:
      return PropertyTab::lights;
    case Part::none:
      break;
  }
  return otherwise;
}

Selection selectionOf(PropertyTab tab, const Selection& current) {
  if (tabOf(current, PropertyTab::rays) == tab) return current;
  switch (tab) {
    case PropertyTab::eye:
      return {Part::eye, 0};
    case PropertyTab::original:
      return {Part::original, 0};
    case PropertyTab::mirror:
      return {Part::mirror, 0};
    case PropertyTab::sculpture:
      return {Part::sculpture, 0};
    default:
      return current;
  }
}

}  // namespace

void openTab(PropertyTabs& tabs, Selection& selection, PropertyTab tab) {
  selection = selectionOf(tab, selection);
  tabs = {tab, selection};
}

void followSelection(PropertyTabs& tabs, const Selection& selection) {
  if (!(tabs.selection == selection)) tabs = {tabOf(selection, tabs.open), selection};
}

}  // namespace anamorph
