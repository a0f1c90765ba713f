#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "case/files.hpp"
#include "case/json/ordered.hpp"
#include "properties/campaign/state.hpp"

namespace rayproof::campaign {

namespace {

using Json = nlohmann::ordered_json;

/// Numbers that must come back to the last bit, infinities too.
std::string exact_text(double x) { return fmt::format("{:a}", x); }
double exact_number(const Json& json) {
  const auto text = json.get<std::string>();
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != 0) throw std::runtime_error("\"" + text + "\" is no number");
  return number;
}

/// The worst errors and counts by name: one list for writing and for reading.
void each_figure(auto& worst, auto&& visit) {
  visit("verdict", worst.verdict);
  visit("residual", worst.residual);
  visit("ulp", worst.ulp);
  visit("point", worst.point);
  visit("normal", worst.normal);
  visit("coordinates", worst.coordinates);
  visit("wrong", worst.wrong);
  visit("cases", worst.cases);
  visit("details", worst.details);
  visit("transformed", worst.transformed);
}

Json json_of(const Worst& worst) {
  Json json = Json::object();
  each_figure(worst, [&]<class T>(const char* name, const T& value) {
    if constexpr (std::is_same_v<T, double>)
      json[name] = exact_text(value);
    else
      json[name] = value;
  });
  return json;
}

Worst worst_of(const Json& json) {
  Worst worst;
  each_figure(worst, [&]<class T>(const char* name, T& value) {
    if constexpr (std::is_same_v<T, double>)
      value = exact_number(json.at(name));
    else
      value = json.at(name).get<T>();
  });
  return worst;
}

Json json_of(const UnitState& one) {
  Json judged = Json::object(), first = Json::object();
  for (std::size_t p = 0; p < properties().size(); ++p) {
    const PropertyTally& tally = one.unit.tally.properties.at(p);
    if (tally.judged() + tally.outside > 0)
      judged[std::string(properties()[p].name)] = {tally.held, tally.broken, tally.outside};
  }
  for (const auto& [property, number] : one.first_broken)
    first[std::string(properties()[property].name)] = number;
  return {{"method", one.unit.subject->full_name()},
          {"family", one.unit.family->name},
          {"precision", name_of(one.unit.precision)},
          {"cases", one.unit.tally.cases},
          {"worst", json_of(one.unit.tally.worst)},
          {"held, broken, outside", judged},
          {"first broken by case", first}};
}

std::size_t index_of(const std::string& property) {
  const Property* const found = find_property(property);
  if (found == nullptr) throw std::runtime_error("there is no property " + property);
  return static_cast<std::size_t>(found - properties().data());
}

void take(UnitState& one, const Json& json) {
  if (json.at("method") != one.unit.subject->full_name() || json.at("family") != one.unit.family->name ||
      json.at("precision") != name_of(one.unit.precision))
    throw std::runtime_error("its methods and families are not those of this program");
  one.unit.tally.cases = json.at("cases").get<std::uint64_t>();
  one.unit.tally.worst = worst_of(json.at("worst"));
  for (const auto& [name, counts] : json.at("held, broken, outside").items()) {
    PropertyTally& tally = one.unit.tally.properties.at(index_of(name));
    tally = {counts.at(0).get<std::uint64_t>(), counts.at(1).get<std::uint64_t>(),
             counts.at(2).get<std::uint64_t>()};
  }
  for (const auto& [name, number] : json.at("first broken by case").items())
    one.first_broken[index_of(name)] = number.get<std::uint64_t>();
}

/// How many cases a unit of the shard has been given.
std::uint64_t cases_done(const CampaignState& state, std::size_t unit) {
  const std::uint64_t all = state.cases_of(state.units[unit].unit), whole = all / cases_in_block;
  const std::uint64_t blocks = state.rounds + (unit < state.units_ahead ? 1 : 0);
  // The shard's blocks are number - 1, number - 1 + count, and so on; the last of the unit may be a part.
  const auto below = [&](std::uint64_t end) {
    const std::uint64_t first = state.shard.number - 1;
    return std::min(blocks, end <= first ? 0 : (end - first - 1) / state.shard.count + 1);
  };
  return below(whole) * cases_in_block + (below(whole + 1) - below(whole)) * (all % cases_in_block);
}

/// Throws where the counts are not those of the rounds.
void check_counts(const CampaignState& state) {
  if (state.rounds > state.all_rounds() || state.units_ahead >= state.units.size() ||
      (state.is_whole() && state.units_ahead > 0))
    throw std::runtime_error("it has more rounds than there are");
  for (std::size_t i = 0; i < state.units.size(); ++i)
    if (state.units[i].unit.tally.cases != cases_done(state, i))
      throw std::runtime_error("its counts of cases are not those of its rounds");
}

Settings settings_of(const Json& json) {
  const auto names = [&](const char* field) { return json.at(field).get<std::vector<std::string>>(); };
  Settings settings{.seed = json.at("seed").get<std::uint64_t>(),
                    .cases = json.at("cases").get<std::uint64_t>()};
  settings.shapes = names("shapes");
  settings.methods = names("methods");
  settings.properties = names("properties");
  settings.families = names("families");
  for (const std::string& name : names("precisions")) settings.precisions.push_back(precision_named(name));
  settings.measure_all = json.at("measure").get<bool>();
  if (settings.cases < 1 || settings.cases > most_cases)
    throw std::runtime_error("its number of cases is not from 1 to 1e12");
  return settings;
}

}  // namespace

std::string write_state(const CampaignState& state) {
  const Settings& settings = state.settings;
  Json precisions = Json::array(), units = Json::array();
  for (const Precision one : settings.precisions) precisions.push_back(name_of(one));
  for (const UnitState& one : state.units) units.push_back(json_of(one));
  const Json json{{"seed", settings.seed},
                  {"cases", settings.cases},
                  {"shapes", settings.shapes},
                  {"methods", settings.methods},
                  {"properties", settings.properties},
                  {"families", settings.families},
                  {"precisions", precisions},
                  {"measure", settings.measure_all},
                  {"shard", {state.shard.number, state.shard.count}},
                  {"rounds", state.rounds},
                  {"units ahead", state.units_ahead},
                  {"units", units}};
  return write_json(json, 1) + "\n";
}

CampaignState read_state(const std::string& text) {
  try {
    const Json json = read_json(text);
    const Shard shard{json.at("shard").at(0).get<std::uint64_t>(),
                      json.at("shard").at(1).get<std::uint64_t>()};
    if (shard.number < 1 || shard.number > shard.count || shard.count > most_shards)
      throw std::runtime_error("its shard is not one of its shards");
    CampaignState state = begin(settings_of(json), shard);
    state.rounds = json.at("rounds").get<std::uint64_t>();
    state.units_ahead = json.at("units ahead").get<std::size_t>();
    if (json.at("units").size() != state.units.size())
      throw std::runtime_error("its methods and families are not those of this program");
    for (std::size_t i = 0; i < state.units.size(); ++i) take(state.units[i], json.at("units").at(i));
    check_counts(state);
    return state;
  } catch (const Json::exception&) {
    throw std::runtime_error("it is no state of a campaign");
  }
}

void save(const CampaignState& state, const std::string& file) { write_file(file, write_state(state)); }

CampaignState load(const std::string& file) {
  std::ifstream in = opened_to_read(file);
  const std::string text = whole_text(in, file);
  try {
    return read_state(text);
  } catch (const std::runtime_error& trouble) {
    throw std::runtime_error(file + ": " + trouble.what());
  }
}

}  // namespace rayproof::campaign
