#include "game/content/template_set.h"

#include "game/content/xml_file.h"

#include <set>

namespace brittle::content {
namespace {

Template readOne(const XmlFile& xml, const pugi::xml_node& node) {
  Template result;
  result.line = xml.lineOf(node);
  std::set<std::string_view> seen;
  for (const pugi::xml_node& properties : node.children("properties")) {
    for (const pugi::xml_attribute& attribute : properties.attributes()) {
      const int line = xml.lineOf(attribute.name());
      if (seen.insert(attribute.name()).second) {
        result.attributes.push_back({attribute.name(), attribute.value(), line});
      } else {
        xml.report({xml.file(),
                    line,
                    std::string("duplicate attribute ") + attribute.name() + ": the first counts",
                    attribute.value(),
                    {}});
      }
    }
  }
  return result;
}

}  // namespace

const Template* TemplateSet::find(std::string_view name) const {
  const auto found = templates.find(name);
  return found == templates.end() ? nullptr : &found->second;
}

TemplateSet readTemplates(const std::string& text, const std::string& file) {
  TemplateSet set;
  set.file = file;
  const XmlFile xml(text, file, "templates", set.problems);
  for (const pugi::xml_node& node : xml.elements()) {
    if (std::string_view(node.name()) != "template") continue;
    const std::string name = node.attribute("name").value();
    if (name.empty()) {
      xml.report({file, xml.lineOf(node), "<template> without a name", {}, {}});
    } else if (!set.templates.emplace(name, readOne(xml, node)).second) {
      xml.report({file, xml.lineOf(node), "a template of this name exists already: the first counts", name, {}});
    }
  }
  return set;
}

}  // namespace brittle::content
