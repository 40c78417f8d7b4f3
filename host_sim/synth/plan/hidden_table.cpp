#include <algorithm>

#include "host_sim/synth/life/catalogue.hpp"
#include "host_sim/synth/plan/tables.hpp"
#include "host_sim/synth/plan/toml_values.hpp"
#include "host_sim/synth/tension/catalogue.hpp"

namespace host_sim::synth {
namespace {

Values values_in(const TomlTable& table, const std::vector<Parameter>& parameters,
                 const std::vector<Choice>& choices) {
  std::vector<NumberKey> keys;
  std::vector<std::string_view> others;
  std::transform(parameters.begin(), parameters.end(), std::back_inserter(keys),
                 [](const Parameter& parameter) { return parameter.key; });
  std::transform(choices.begin(), choices.end(), std::back_inserter(others),
                 [](const Choice& choice) { return choice.name; });
  table.refuse_unknown_keys(keys, others);
  Values values;
  for (const Parameter& parameter : parameters) {
    if (parameter.standard && !table.has(parameter.key.name)) {
      values.set(parameter.key.name, {*parameter.standard});
    } else if (parameter.list) {
      values.set(parameter.key.name, numbers(table, parameter.key));
    } else {
      values.set(parameter.key.name, {table.number(parameter.key)});
    }
  }
  for (const Choice& choice : choices) {
    values.choose(choice.name, choice.words[word(table, choice.name, choice.words)]);
  }
  return values;
}

template <class Kinds>
void add_ids(const Kinds& kinds, std::vector<std::string_view>& ids) {
  for (const auto& kind : kinds) {
    ids.push_back(kind.id);
  }
}

template <class Kinds>
void read(const TomlTable& table, const Kinds& kinds, const Hidden& like,
          std::vector<Hidden>& hidden) {
  for (const auto& kind : kinds) {
    if (table.has(kind.id)) {
      Hidden one = like;
      one.id = kind.id;
      one.values = values_in(table.table(kind.id), kind.parameters, kind.choices);
      hidden.push_back(std::move(one));
    }
  }
}

}  // namespace

std::vector<Hidden> hidden_in(const TomlTable& table, bool outside) {
  const auto tension = outside ? outside_tension_kinds() : tension_kinds();
  const auto life = outside ? outside_life_kinds() : life_kinds();
  std::vector<std::string_view> ids;
  add_ids(tension, ids);
  add_ids(life, ids);
  table.refuse_unknown_keys({}, ids);
  std::vector<Hidden> hidden;
  Hidden like;
  like.outside = outside;
  read(table, tension, like, hidden);
  like.of_life = true;
  read(table, life, like, hidden);
  return hidden;
}

}  // namespace host_sim::synth
