#include "base/units.h"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <string_view>

#include "base/errors.h"

namespace geneva::base {

namespace {

/// Powers of metre, kilogram, second and radian.
using Powers = std::array<int, 4>;

/// A unit as UDUNITS-2 understands it.
struct UnitMeaning {
  double scale = 1.;  ///< SI units per unit
  Powers powers{};
  bool is_scale = true;  ///< false: has an offset, a logarithm, a date or another base unit
};

struct DimensionFacts {
  const char* name;
  const char* wanted;
  const char* example;
  Powers powers;
  std::array<const char*, 3> output;  ///< by UnitSystem
};

/// By UnitSystem.
constexpr std::array<std::string_view, 3> unit_system_names{"SI", "mm-N", "in-lbf"};

const std::array<DimensionFacts, 20>& all_facts() {
  // in the order of the enumeration
  static const std::array<DimensionFacts, 20> table{{
      {"plain number",
       "a plain number or a percentage",
       "'0.3' or '30 %'",
       {0, 0, 0, 0},
       {"", "", ""}},
      {"length",
       "a length with its unit",
       "'4.53 in' or '115 mm'",
       {1, 0, 0, 0},
       {"m", "mm", "in"}},
      {"angle",
       "an angle with its unit",
       "'-11.46 deg' or '-0.2 rad'",
       {0, 0, 0, 1},
       {"rad", "deg", "deg"}},
      {"slope",
       "a small angle with its unit",
       "'0.1 deg' or '2 mrad'",
       {0, 0, 0, 1},
       {"mrad", "mrad", "mrad"}},
      {"angular speed",
       "an angular speed with its unit",
       "'600 rpm' or '62.8 rad/s'",
       {0, 0, -1, 1},
       {"rad/s", "rpm", "rpm"}},
      {"angular acceleration",
       "an angular acceleration with its unit",
       "'100 rad/s^2' or '5 rpm/s'",
       {0, 0, -2, 1},
       {"rad/s^2", "rad/s^2", "rad/s^2"}},
      {"acceleration",
       "an acceleration with its unit",
       "'9.81 m/s^2' or '386 in/s^2'",
       {1, 0, -2, 0},
       {"m/s^2", "mm/s^2", "in/s^2"}},
      {"stress",
       "a stress with its unit",
       "'30e6 psi' or '207 GPa'",
       {-1, 1, -2, 0},
       {"Pa", "MPa", "psi"}},
      {"density",
       "a mass density with its unit",
       "'0.283 lb/in^3' or '7850 kg/m^3'",
       {-3, 1, 0, 0},
       {"kg/m^3", "kg/m^3", "lb/in^3"}},
      {"mass", "a mass with its unit", "'1.5 kg' or '3 lb'", {0, 1, 0, 0}, {"kg", "kg", "lb"}},
      {"force", "a force with its unit", "'100 lbf' or '450 N'", {1, 1, -2, 0}, {"N", "N", "lbf"}},
      {"force per length",
       "a force per length with its unit",
       "'35 kN/mm' or '200 lbf/in'",
       {0, 1, -2, 0},
       {"N/m", "N/mm", "lbf/in"}},
      {"force per volume",
       "a force per volume with its unit",
       "'77e3 N/m^3' or '0.28 lbf/in^3'",
       {-2, 1, -2, 0},
       {"N/m^3", "N/mm^3", "lbf/in^3"}},
      {"moment",
       "a moment with its unit",
       "'2 lbf.in' or '0.2 N.m'",
       {2, 1, -2, 0},
       {"N.m", "N.mm", "lbf.in"}},
      {"moment of inertia",
       "a moment of inertia with its unit",
       "'0.0046 lbf.s^2.in' or '5e-4 kg.m^2'",
       {2, 1, 0, 0},
       {"kg.m^2", "kg.mm^2", "lbf.s^2.in"}},
      {"time", "a time with its unit", "'0.1 s' or '50 ms'", {0, 0, 1, 0}, {"s", "s", "s"}},
      {"speed",
       "a speed with its unit",
       "'2 m/s' or '80 in/s'",
       {1, 0, -1, 0},
       {"m/s", "mm/s", "in/s"}},
      {"pressure times speed",
       "a pressure times a speed with its unit",
       "'1.5 MPa.m/s' or '1000 psi.in/s'",
       {0, 1, -3, 0},
       {"Pa m/s", "MPa mm/s", "psi in/s"}},
      {"wear coefficient",
       "a wear coefficient with its unit",
       "'1e-15 m^2/N' or '1e-6 mm^3/(N.m)'",
       {1, -1, 2, 0},
       {"m^2/N", "mm^2/N", "in^2/lbf"}},
      {"memory",
       "an amount of memory with its unit",
       "'16 GB' or '500 MB'",
       {0, 0, 0, 0},
       {"GB", "GB", "GB"}},
  }};
  return table;
}

const DimensionFacts& facts(const Dimension dimension) {
  return all_facts().at(static_cast<std::size_t>(dimension));
}

using UnitPointer = std::unique_ptr<ut_unit, decltype(&ut_free)>;
using SystemPointer = std::unique_ptr<ut_system, decltype(&ut_free_system)>;

/// The units of UDUNITS-2's database, and the few that it lacks.
class UnitDatabase {
 public:
  UnitDatabase()
      : system_(load()), base_{unit("meter"), unit("kilogram"), unit("second"), unit("radian")} {
    add("deg", "degree");
    add("rev", "revolution");
  }

  /// @return nothing if the unit is unknown or misspelt
  [[nodiscard]] std::optional<UnitMeaning> meaning(const std::string& text) const {
    const UnitPointer parsed(ut_parse(system_.get(), text.c_str(), UT_UTF8), &ut_free);
    if (!parsed) return std::nullopt;
    Visit visit{this, {}};
    if (ut_accept_visitor(parsed.get(), &visitor(), &visit) != UT_SUCCESS)
      visit.meaning.is_scale = false;
    return visit.meaning;
  }

 private:
  struct Visit {
    const UnitDatabase* database;
    UnitMeaning meaning;

    void count(const ut_unit* basic, int power) {
      for (std::size_t i = 0; i < database->base_.size(); ++i) {
        if (ut_compare(basic, database->base_[i].get()) != 0) continue;
        meaning.powers[i] += power;
        return;
      }
      meaning.is_scale = false;
    }
  };

  static SystemPointer load() {
    ut_set_error_message_handler(&ut_ignore);
    SystemPointer system(ut_read_xml(nullptr), &ut_free_system);
    if (!system)
      throw InputError(
          "the unit database of UDUNITS-2 cannot be read: install it, or let UDUNITS2_XML_PATH "
          "name its file udunits2.xml");
    return system;
  }

  [[nodiscard]] UnitPointer unit(const char* name) const {
    UnitPointer found(ut_get_unit_by_name(system_.get(), name), &ut_free);
    if (!found)
      throw InputError(fmt::format("the unit database of UDUNITS-2 does not know the {}", name));
    return found;
  }

  /// A database that already knows the symbol keeps its own meaning.
  void add(const char* symbol, const char* name) const {
    const UnitPointer known = unit(name);
    ut_map_symbol_to_unit(symbol, UT_ASCII, known.get());
  }

  static ut_status visit_basic(const ut_unit* unit, void* data) {
    static_cast<Visit*>(data)->count(unit, 1);
    return UT_SUCCESS;
  }
  static ut_status visit_product(const ut_unit* /*unit*/, int count, const ut_unit* const* units,
                                 const int* powers, void* data) {
    for (int i = 0; i < count; ++i) static_cast<Visit*>(data)->count(units[i], powers[i]);
    return UT_SUCCESS;
  }
  static ut_status visit_galilean(const ut_unit* /*unit*/, double scale, const ut_unit* underlying,
                                  double offset, void* data) {
    UnitMeaning& meaning = static_cast<Visit*>(data)->meaning;
    meaning.scale *= scale;
    if (offset != 0.) meaning.is_scale = false;
    return ut_accept_visitor(underlying, &visitor(), data);
  }
  static ut_status visit_timestamp(const ut_unit* /*unit*/, const ut_unit* /*time*/,
                                   double /*origin*/, void* data) {
    static_cast<Visit*>(data)->meaning.is_scale = false;
    return UT_SUCCESS;
  }
  static ut_status visit_logarithmic(const ut_unit* /*unit*/, double /*base*/,
                                     const ut_unit* /*reference*/, void* data) {
    static_cast<Visit*>(data)->meaning.is_scale = false;
    return UT_SUCCESS;
  }
  static const ut_visitor& visitor() {
    static const ut_visitor functions{&visit_basic, &visit_product, &visit_galilean,
                                      &visit_timestamp, &visit_logarithmic};
    return functions;
  }

  SystemPointer system_;
  std::array<UnitPointer, 4> base_;
};

const UnitDatabase& unit_database() {
  static const UnitDatabase database;
  return database;
}

[[noreturn]] void refuse(const std::string& text, Dimension dimension, const std::string& reason) {
  throw InputError(fmt::format("{}: {}{}{} is wanted, for example {}", in_quotes(text), reason,
                               reason.empty() ? "" : "; ", wanted(dimension),
                               example_of(dimension)));
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

/// A number in a unit that is not the power of what stands before it: UDUNITS-2 would multiply.
bool has_factor(std::string_view unit) {
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (!is_digit(unit[i])) continue;
    if (i > 0 && is_digit(unit[i - 1])) continue;
    std::size_t before = i;
    if (before > 0 && (unit[before - 1] == '-' || unit[before - 1] == '+')) --before;
    if (before == 0 || !(is_letter(unit[before - 1]) || unit[before - 1] == '^')) return true;
  }
  return false;
}

struct Quantity {
  double number;
  std::string unit;
};

Quantity split(const std::string& text, Dimension dimension) {
  std::string_view rest = trimmed(text);
  if (rest.size() > 1 && rest[0] == '+' && rest[1] != '-') rest.remove_prefix(1);
  double number = 0.;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (error == std::errc::result_out_of_range)
    refuse(text, dimension, "the number is too large or too small");
  if (error != std::errc()) refuse(text, dimension, "");
  if (!std::isfinite(number)) refuse(text, dimension, "the number is not finite");
  rest = trimmed(rest.substr(static_cast<std::size_t>(end - rest.data())));
  if (rest.size() > 1 && rest[0] == ',' && is_digit(rest[1]))
    refuse(text, dimension, "a decimal number is written with a point");
  return {number, std::string(rest)};
}

/// What a user may have meant whose unit has other powers than those wanted.
std::string hint(const Powers& found, const Powers& wanted) {
  const auto differs_by = [&](const Powers& difference) {
    for (std::size_t i = 0; i < found.size(); ++i)
      if (wanted[i] - found[i] != difference[i]) return false;
    return true;
  };
  if (differs_by({0, 0, 0, 1}) && wanted[2] < 0)
    return " (turns or radians? write 'rpm', 'rad/s' or 'deg/s')";
  if (differs_by({1, 0, -2, 0}))
    return " ('lb' and 'kg' are masses: the units of force are 'lbf', 'kgf' and 'N')";
  if (differs_by({-1, 0, 2, 0}))
    return " ('lbf' and 'N' are forces: the units of mass are 'lb', 'lbf.s^2/in' and 'kg')";
  return "";
}

/// The product that a user may have meant who left out its point: 'N.m' for 'Nm'.
std::string product_hint(const std::string& unit, const Dimension dimension) {
  constexpr std::size_t longest = 12;
  if (unit.size() > longest) return "";
  if (dimension == Dimension::angular_speed &&
      (unit == "1/min" || unit == "min^-1" || unit == "U/min" || unit == "min-1"))
    return " (did you mean 'rpm'?)";
  for (std::size_t place = 1; place < unit.size(); ++place) {
    if (!is_letter(unit[place - 1]) || !is_letter(unit[place])) continue;
    const std::string product = unit.substr(0, place) + "." + unit.substr(place);
    const auto meaning = unit_database().meaning(product);
    if (meaning && meaning->is_scale && meaning->powers == facts(dimension).powers)
      return fmt::format(" (did you mean {}?)", in_quotes(product));
  }
  return "";
}

double scale_of(const std::string& unit, Dimension dimension, const std::string& text) {
  if (unit.empty()) refuse(text, dimension, "");
  constexpr std::size_t longest = 100;
  const auto meaning = unit.size() > longest || has_factor(unit) || unit.find('\0') < unit.size()
                           ? std::nullopt
                           : unit_database().meaning(unit);
  if (!meaning)
    refuse(
        text, dimension,
        fmt::format("{} is no unit known here{}", in_quotes(unit), product_hint(unit, dimension)));
  const Powers& powers = facts(dimension).powers;
  if (!meaning->is_scale || meaning->powers != powers)
    refuse(text, dimension,
           fmt::format("{} is no unit of {}{}", in_quotes(unit), name_of(dimension),
                       hint(meaning->powers, powers)));
  return meaning->scale;
}

/// What a user may have meant who gives a hardness with its scale; Rockwell's numbers are converted
/// by tables only (ISO 18265), of which one pair shows the size of the number that is wanted.
std::string hardness_hint(const std::string& unit) {
  if (unit == "HRC" || unit == "HRc" || unit == "Rc")
    return " (a hardness is Vickers' or Brinell's number: 58 HRC is about 650)";
  if (unit == "HV" || unit == "HB" || unit == "HBW" || unit == "BHN")
    return " (a hardness is given as its number alone)";
  return "";
}

/// UDUNITS-2 takes radians, bits and bytes for plain numbers too.
double dimensionless_scale(const std::string& unit, const std::string& text) {
  if (unit.empty()) return 1.;
  if (unit == "%" || unit == "percent") return 0.01;
  refuse(
      text, Dimension::dimensionless,
      fmt::format("{} does not belong to a plain number{}", in_quotes(unit), hardness_hint(unit)));
}

double memory_scale(const std::string& unit, const std::string& text) {
  constexpr std::array<std::pair<const char*, double>, 10> units{{{"B", 1.},
                                                                  {"byte", 1.},
                                                                  {"kB", 1e3},
                                                                  {"MB", 1e6},
                                                                  {"GB", 1e9},
                                                                  {"TB", 1e12},
                                                                  {"KiB", 1024.},
                                                                  {"MiB", 1048576.},
                                                                  {"GiB", 1073741824.},
                                                                  {"TiB", 1099511627776.}}};
  for (const auto& [name, bytes] : units)
    if (unit == name) return bytes;
  refuse(text, Dimension::memory,
         unit.empty() ? "" : fmt::format("{} is no unit of memory known here", in_quotes(unit)));
}

double any_scale(const std::string& unit, Dimension dimension, const std::string& text) {
  if (dimension == Dimension::dimensionless) return dimensionless_scale(unit, text);
  if (dimension == Dimension::memory) return memory_scale(unit, text);
  return scale_of(unit, dimension, text);
}

}  // namespace

std::string name_of(Dimension dimension) { return facts(dimension).name; }

bool is_unit(const std::string& text) {
  if (text == "%" || text == "percent") return true;
  constexpr std::size_t longest = 100;
  if (text.empty() || text.size() > longest || has_factor(text)) return false;
  return unit_database().meaning(text).has_value();
}

Dimension dimension_named(const std::string& name) {
  for (std::size_t i = 0; i < all_facts().size(); ++i)
    if (all_facts()[i].name == name) return static_cast<Dimension>(i);
  throw InputError(in_quotes(name) + " is the name of no dimension");
}

std::string name_of(const UnitSystem system) {
  return std::string(unit_system_names.at(static_cast<std::size_t>(system)));
}

UnitSystem unit_system_named(const std::string& name) {
  const auto found = std::find(unit_system_names.begin(), unit_system_names.end(), name);
  if (found == unit_system_names.end())
    throw InputError(
        fmt::format("{} is the name of no system of units; one of 'SI', 'mm-N', 'in-lbf' is wanted",
                    in_quotes(name)));
  return static_cast<UnitSystem>(found - unit_system_names.begin());
}

std::string wanted(Dimension dimension) { return facts(dimension).wanted; }

std::string example_of(Dimension dimension) { return facts(dimension).example; }

std::string in_quotes(const std::string& text) {
  constexpr std::size_t longest = 100;
  if (text.size() <= longest) return "'" + text + "'";
  std::size_t end = longest;
  // not within a character of UTF-8
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return "'" + text.substr(0, end) + "...'";
}

double parse_quantity(const std::string& text, Dimension dimension) {
  const Quantity quantity = split(text, dimension);
  const double value = quantity.number * any_scale(quantity.unit, dimension, text);
  if (!std::isfinite(value)) refuse(text, dimension, "the value is too large");
  return value;
}

OutputUnit output_unit(UnitSystem system, Dimension dimension) {
  const std::string name = facts(dimension).output.at(static_cast<std::size_t>(system));
  return {name, 1. / any_scale(name, dimension, name)};
}

}  // namespace geneva::base
