#include "scene/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace lamina::scene {

using geometry::ExactPoint;
using number::Rational;

namespace {

constexpr std::array<std::string_view, 3> kSpecial{"$fn", "$fa", "$fs"};

template <typename Names>
bool contains(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

Arguments::Arguments(const Source& source, const Node& node, const Signature& signature)
    : source_(source), node_(node), usage_(signature.usage) {
  std::size_t position = 0;
  for (const Argument& argument : node.arguments) {
    if (!argument.name.empty()) {
      const std::string_view name = argument.name;
      if (!contains(signature.positional, name) && !contains(signature.named_only, name) &&
          !contains(kSpecial, name)) {
        fail(argument.offset, fmt::format("there is no argument `{}`", name));
      }
      bind(name, argument);
    } else if (position < signature.positional.size()) {
      bind(signature.positional[position++], argument);
    } else {
      fail(argument.offset, fmt::format("at most {} arguments without a name can be given",
                                        signature.positional.size()));
    }
  }
  for (std::size_t i = 0; i < signature.required; ++i) {
    if (!has(signature.positional[i])) {
      fail(fmt::format("the argument `{}` is missing", signature.positional[i]));
    }
  }
}

void Arguments::bind(std::string_view parameter, const Argument& argument) {
  for (const Binding& earlier : bindings_) {
    if (earlier.parameter == parameter) {
      fail(argument.offset, fmt::format("the argument `{}` is given twice", parameter));
    }
  }
  bindings_.push_back({parameter, &argument});
}

void Arguments::fail(std::size_t offset, std::string_view reason) const {
  source_.fail(offset, fmt::format("`{}`: {}; write {}", node_.name, reason, usage_));
}

void Arguments::fail(std::string_view reason) const { fail(node_.offset, reason); }

void Arguments::fail_at(std::string_view parameter, std::string_view reason) const {
  const Value* value = find(parameter);
  fail(value != nullptr ? value->offset : node_.offset, reason);
}

const Value* Arguments::find(std::string_view parameter) const {
  for (const Binding& binding : bindings_) {
    if (binding.parameter == parameter && !binding.argument->value.undefined()) {
      return &binding.argument->value;
    }
  }
  return nullptr;
}

template <typename Content>
const Content* Arguments::find(std::string_view parameter, std::string_view expected) const {
  const Value* value = find(parameter);
  if (value == nullptr) {
    return nullptr;
  }
  const auto* content = std::get_if<Content>(&value->content);
  if (content == nullptr) {
    fail(value->offset, fmt::format("`{}` must be {}", parameter, expected));
  }
  return content;
}

std::optional<Rational> Arguments::number(std::string_view parameter) const {
  const auto* content = find<Rational>(parameter, "a number");
  return content != nullptr ? std::optional(*content) : std::nullopt;
}

std::optional<Rational> Arguments::size(std::string_view parameter) const {
  const std::optional<Rational> value = number(parameter);
  if (value && value->sign() < 0) {
    fail_at(parameter, fmt::format("`{}` must not be negative", parameter));
  }
  return value;
}

std::optional<bool> Arguments::boolean(std::string_view parameter) const {
  const auto* content = find<bool>(parameter, "true or false");
  return content != nullptr ? std::optional(*content) : std::nullopt;
}

std::optional<std::string> Arguments::text(std::string_view parameter) const {
  const auto* content = find<std::string>(parameter, "a \"string\"");
  return content != nullptr ? std::optional(*content) : std::nullopt;
}

bool Arguments::is_number(std::string_view parameter) const {
  const Value* value = find(parameter);
  return value != nullptr && std::holds_alternative<Rational>(value->content);
}

std::vector<Rational> Arguments::numbers(const Value::List& list,
                                         std::string_view parameter) const {
  std::vector<Rational> result;
  for (const Value& value : list) {
    const auto* number = std::get_if<Rational>(&value.content);
    if (number == nullptr) {
      fail(value.offset, fmt::format("`{}` must hold numbers", parameter));
    }
    result.push_back(*number);
  }
  return result;
}

std::optional<std::vector<Rational>> Arguments::numbers(std::string_view parameter) const {
  const auto* list = find<Value::List>(parameter, "a list of numbers");
  return list != nullptr ? std::optional(numbers(*list, parameter)) : std::nullopt;
}

std::optional<ExactPoint> Arguments::vector(std::string_view parameter,
                                            const std::optional<Rational>& third) const {
  std::optional<std::vector<Rational>> list = numbers(parameter);
  if (!list) {
    return std::nullopt;
  }
  if (list->size() == 2 && third) {
    list->push_back(*third);
  }
  if (list->size() != 3) {
    fail_at(parameter, fmt::format("`{}` must have three coordinates", parameter));
  }
  return ExactPoint{(*list)[0], (*list)[1], (*list)[2]};
}

std::optional<ExactPoint> Arguments::vector_or_number(std::string_view parameter,
                                                      const std::optional<Rational>& third) const {
  if (!is_number(parameter)) {
    return vector(parameter, third);
  }
  const Rational value = *number(parameter);
  return ExactPoint{value, value, value};
}

std::optional<std::vector<std::vector<Rational>>> Arguments::matrix(
    std::string_view parameter, std::optional<std::size_t> columns) const {
  const auto* rows = find<Value::List>(parameter, "a list of rows");
  if (rows == nullptr) {
    return std::nullopt;
  }
  std::vector<std::vector<Rational>> result;
  for (const Value& row : *rows) {
    const auto* list = std::get_if<Value::List>(&row.content);
    if (list == nullptr || list->size() != columns.value_or(list->size())) {
      fail(row.offset, fmt::format("a row of `{}` must be a list of {}numbers", parameter,
                                   columns ? fmt::format("{} ", *columns) : ""));
    }
    result.push_back(numbers(*list, parameter));
  }
  return result;
}

std::optional<Color> Arguments::color(std::string_view parameter) const {
  const Value* value = find(parameter);
  if (value == nullptr) {
    return std::nullopt;
  }
  if (const auto* name = std::get_if<std::string>(&value->content)) {
    const std::optional<Color> color = color_of_name(*name);
    if (!color) {
      fail_at(parameter, fmt::format("`{}` is no colour; names are those of CSS", *name));
    }
    return color;
  }
  const std::vector<Rational> components = *numbers(parameter);
  if (components.size() != 3 && components.size() != 4) {
    fail_at(parameter, fmt::format("`{}` must have three or four components", parameter));
  }
  Color color{0, 0, 0, 1};
  std::copy(components.begin(), components.end(), color.begin());
  if (color[0] == -1 && color[1] == -1 && color[2] == -1) {
    return std::nullopt;
  }
  if (std::any_of(color.begin(), color.end(), [](const Rational& c) { return c < 0 || c > 1; })) {
    fail_at(parameter, fmt::format("the components of `{}` must be from 0 to 1", parameter));
  }
  return color;
}

FacetSettings Arguments::facets(FacetSettings outside) const {
  return {number("$fn").value_or(outside.fn), number("$fa").value_or(outside.fa),
          number("$fs").value_or(outside.fs)};
}

}  // namespace lamina::scene
