// content/template_set.h - named sets of attributes that lie under those of the elements that name them.
#pragma once

#include "game/content/problem.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace brittle::content {

/// Problem::what of an element that names a template which is not in the set.
inline constexpr const char* kUnknownTemplate = "unknown template";

struct TemplateAttribute {
  std::string name;
  std::string value;
  int line = 0;
};

struct Template {
  std::vector<TemplateAttribute> attributes;  // names differ
  int line = 0;
};

struct TemplateSet {
  std::string file;
  std::map<std::string, Template, std::less<>> templates;
  Problems problems;

  const Template* find(std::string_view name) const;
};

/// Reads a templates.xml. Never fails: what is wrong is in `problems`.
TemplateSet readTemplates(const std::string& text, const std::string& file);

}  // namespace brittle::content
