// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_floors.h"

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "models/import/text.h"

namespace sidestep::importer {
namespace {

void AddGeomNames(const XmlElement& element, std::set<std::string>* names) {
  if (element.tag == "geom") names->insert(element.Text("name"));
  for (const XmlElement& child : element.children) AddGeomNames(child, names);
}

}  // namespace

void StandInForFloors(XmlElement* worldbody, XmlElement* contact, Notes* notes) {
  std::set<std::string> geoms;
  AddGeomNames(*worldbody, &geoms);
  std::erase_if(contact->children, [&](const XmlElement& pair) {
    return geoms.count(pair.Text("geom1")) + geoms.count(pair.Text("geom2")) == 0;
  });
  std::vector<std::string> floors;
  for (const XmlElement& pair : contact->children) {
    for (const char* which : {"geom1", "geom2"}) {
      if (geoms.insert(pair.Text(which)).second) floors.push_back(pair.Text(which));
    }
  }
  for (const std::string& name : floors) {
    XmlElement plane{"geom", {}, {}, 0, {}};
    plane.attributes = {{"name", name}, {"type", "plane"}, {"size", "1 1 1"}};
    worldbody->children.push_back(std::move(plane));
  }
  if (!floors.empty()) {
    notes->push_back("took " + Listed(floors) +
                     ", named by <pair> and not in the file, for floors");
  }
}

}  // namespace sidestep::importer
