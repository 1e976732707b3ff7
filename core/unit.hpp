// SPDX-License-Identifier: MIT
// The one list of units: what is measured, how a unit is written in a key ("_mm_s2"), in a message ("mm/s^2")
// and to a reader ("mm/s²"), and its size in SI.
//
//     SI value = written value · factor
//
// A unit is named by its symbols: products by a blank, what it is divided by after a slash, powers by ^. All
// else follows from the table of symbols: unit_named<"lbf in/rad">. Angles count in rad; a symbol above and
// below the line cancels. Lists of the units that a quantity may have are in namespace spellings.
#pragma once

#include "core/units.hpp"

#include <span>
#include <string_view>

namespace camopt {

/// Powers of what a unit measures. Force and pressure are separate: no key is in kg m/s² instead of N. A
/// crank turns twice while the camshaft turns once, so that its degrees are no angle of the cam.
struct Quantity {
    signed char length = 0, angle = 0, time = 0, mass = 0, force = 0, pressure = 0, crank = 0;

    friend constexpr bool operator==(const Quantity&, const Quantity&) = default;
};

enum class UnitSystem : unsigned char { both, metric, imperial };

/// One spelling of a quantity: key = name + suffix, SI value = written value · factor.
struct Spelling {
    std::string_view suffix;  ///< "_mm_s2"
    std::string_view unit;    ///< "mm/s^2"; empty: dimensionless
    double factor = 1.0;
    std::string_view sign = {};  ///< "mm/s²", for a reader
    Quantity quantity = {};
    UnitSystem system = UnitSystem::both;
};

namespace unit_grammar {

/// size / per SI units: of whole numbers where it can be, so that 1 g/cm³ is 1000 kg/m³ to the last digit.
struct Symbol {
    std::string_view name;
    double size, per;
    Quantity quantity;
    UnitSystem system = UnitSystem::both;
    std::string_view sign = {};  ///< empty: as its name
};

inline constexpr Quantity length{.length = 1}, angle{.angle = 1}, time{.time = 1}, mass{.mass = 1},
    force{.force = 1}, pressure{.pressure = 1}, frequency{.angle = 1, .time = -1};
inline constexpr Symbol symbols[] = {
    {"mm", 1.0, 1e3, length, UnitSystem::metric},
    {"cm", 1.0, 1e2, length, UnitSystem::metric},
    {"m", 1.0, 1.0, length, UnitSystem::metric},
    {"um", 1.0, 1e6, length, UnitSystem::metric, "µm"},
    {"in", units::inch, 1.0, length, UnitSystem::imperial},
    {"mil", units::inch, 1e3, length, UnitSystem::imperial},
    {"deg", units::degree, 1.0, angle},
    {"mdeg", units::degree, 1e3, angle},
    {"rad", 1.0, 1.0, angle},
    {"rev", units::turn, 1.0, angle},
    {"crank", 1.0, 2.0, {.crank = 1}},
    {"s", 1.0, 1.0, time},
    {"min", units::minute, 1.0, time},
    {"rpm", units::revolution_per_minute, 1.0, frequency},
    {"Hz", units::turn, 1.0, frequency},
    {"kg", 1.0, 1.0, mass, UnitSystem::metric},
    {"g", 1.0, 1e3, mass, UnitSystem::metric},
    {"lb", units::pound, 1.0, mass, UnitSystem::imperial},
    {"N", 1.0, 1.0, force, UnitSystem::metric},
    {"lbf", units::pound_force, 1.0, force, UnitSystem::imperial},
    {"Pa", 1.0, 1.0, pressure, UnitSystem::metric},
    {"MPa", 1e6, 1.0, pressure, UnitSystem::metric},
    {"GPa", 1e9, 1.0, pressure, UnitSystem::metric},
    {"ksi", units::ksi, 1.0, pressure, UnitSystem::imperial},
};

/// A short text made by the compiler.
struct Text {
    char letters[24] = {};
    std::size_t size = 0;

    constexpr void add(char letter) { letters[size++] = letter; }
    constexpr void add(std::string_view text) {
        for (const char letter : text) add(letter);
    }
    [[nodiscard]] constexpr std::string_view view() const { return {letters, size}; }
};

/// The name of a unit as an argument of a template.
template <std::size_t n>
struct Name {
    char letters[n] = {};

    consteval Name(const char (&text)[n]) { std::ranges::copy(text, letters); }  // NOLINT: a literal is meant
    [[nodiscard]] constexpr std::string_view view() const { return {letters, n - 1}; }
};

struct Unit {
    Text suffix, sign;
    double size = 1.0, per = 1.0;
    Quantity quantity;
    UnitSystem system = UnitSystem::both;
};

/// A symbol that the table does not have: never compiled.
[[noreturn]] void no_such_symbol();

constexpr const Symbol& symbol_named(std::string_view name) {
    for (const Symbol& symbol : symbols)
        if (symbol.name == name) return symbol;
    no_such_symbol();
}

constexpr void raise(Quantity& quantity, const Quantity& by, int power) {
    const auto add = [&](signed char Quantity::*one) {
        quantity.*one = static_cast<signed char>(quantity.*one + power * by.*one);
    };
    for (const auto one : {&Quantity::length, &Quantity::angle, &Quantity::time, &Quantity::mass,
                           &Quantity::force, &Quantity::pressure, &Quantity::crank})
        add(one);
}

constexpr char lower(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

/// One symbol of a name: "/s^2".
struct Factor {
    const Symbol* symbol;
    char before;  ///< '/', ' '; 0: the first
    int power;    ///< as written
};

/// Takes it off the rest of the name.
constexpr Factor next_factor(std::string_view& rest) {
    const char before = rest.front() == '/' || rest.front() == ' ' ? rest.front() : '\0';
    if (before != '\0') rest.remove_prefix(1);
    const std::size_t end = std::min(rest.find_first_of(" /^"), rest.size());
    Factor factor{&symbol_named(rest.substr(0, end)), before, 1};
    rest.remove_prefix(end);
    if (rest.starts_with('^')) {
        factor.power = rest[1] - '0';
        rest.remove_prefix(2);
    }
    return factor;
}

/// "_nm" is the newton metre of every key; a travel is "_mm_per_rev".
constexpr void add_suffix(Text& suffix, const Factor& factor) {
    const std::string_view name = factor.symbol->name;
    if (!(factor.before == ' ' && name == "m" && suffix.view() == "_n")) suffix.add("_");
    if (factor.before == '/' && name == "rev") suffix.add("per_");
    for (const char letter : name) suffix.add(lower(letter));
    if (factor.power > 1) suffix.add(static_cast<char>('0' + factor.power));
}

constexpr void add_sign(Text& sign, const Factor& factor) {
    if (factor.before != '\0') sign.add(factor.before);
    sign.add(factor.symbol->sign.empty() ? factor.symbol->name : factor.symbol->sign);
    sign.add(factor.power == 2 ? "²" : factor.power == 3 ? "³" : "");
}

constexpr Unit unit_of(std::string_view name) {
    Unit unit;
    bool below = false;
    while (!name.empty()) {
        const Factor factor = next_factor(name);
        const Symbol& symbol = *factor.symbol;
        below = below || factor.before == '/';
        for (int i = 0; i < factor.power; ++i) {
            unit.size *= below ? symbol.per : symbol.size;
            unit.per *= below ? symbol.size : symbol.per;
        }
        raise(unit.quantity, symbol.quantity, below ? -factor.power : factor.power);
        if (symbol.system != UnitSystem::both) unit.system = symbol.system;
        add_suffix(unit.suffix, factor);
        add_sign(unit.sign, factor);
    }
    return unit;
}

template <Name name>
inline constexpr Unit parsed = unit_of(name.view());
template <Name name>
inline constexpr Name kept = name;

}  // namespace unit_grammar

/// unit_named<"mm/s^2">, unit_named<"">: what has none.
template <unit_grammar::Name name>
inline constexpr Spelling unit_named = {unit_grammar::parsed<name>.suffix.view(),
                                        unit_grammar::kept<name>.view(),
                                        unit_grammar::parsed<name>.size / unit_grammar::parsed<name>.per,
                                        unit_grammar::parsed<name>.sign.view(),
                                        unit_grammar::parsed<name>.quantity,
                                        unit_grammar::parsed<name>.system};

/// The units that a quantity may have, the one of the manual first.
template <unit_grammar::Name... names>
inline constexpr std::array<Spelling, sizeof...(names)> units_named = {unit_named<names>...};

/// The unit that a key ends in: "limits.velocity_mm_s"; null: none.
[[nodiscard]] const Spelling* unit_of_key(std::string_view key);

/// Of an angle, or of a derivative of one by time.
[[nodiscard]] constexpr bool is_angle_unit(std::string_view unit) {
    return unit.starts_with("deg") || unit.starts_with("rad");
}

/// A key whose number is an angle: "motion.rise_deg".
[[nodiscard]] bool is_angle_key(std::string_view key);

/// Counts by time: "mm/s", "rad/s^2".
[[nodiscard]] constexpr bool is_unit_of_time(std::string_view unit) {
    return unit.find("/s") != std::string_view::npos;
}

namespace spellings {

/// The same unit, written otherwise in a key.
[[nodiscard]] consteval Spelling with_suffix(Spelling spelling, std::string_view suffix) {
    spelling.suffix = suffix;
    return spelling;
}

inline constexpr auto plain = units_named<"">;
inline constexpr auto length = units_named<"mm", "in", "m">;
inline constexpr auto angle = units_named<"deg", "rad">;
/// Of the motion: two crank degrees are one of the cam.
inline constexpr auto cam_angle = units_named<"deg", "rad", "crank deg">;
/// Where the name of the key is the unit.
inline constexpr std::array degrees = {with_suffix(unit_named<"deg">, "")};
inline constexpr auto lift = units_named<"mm", "in", "m", "deg", "rad">;
inline constexpr auto speed = units_named<"rpm", "rad/s">;
inline constexpr auto frequency = units_named<"Hz", "rad/s">;
inline constexpr auto rotary_speed = units_named<"deg/s", "rad/s", "rpm">;
/// Of a cutter.
inline constexpr auto feed = units_named<"mm/min", "in/min", "m/min", "mm/s">;
inline constexpr auto vibration = units_named<"um", "mm", "in", "deg", "rad">;
inline constexpr auto travel_per_turn = units_named<"mm/rev", "in/rev", "m/rev", "deg/rev", "rad/rev">;

inline constexpr auto mass = units_named<"kg", "lb">;
inline constexpr auto inertia = units_named<"kg m^2">;
inline constexpr auto density = units_named<"kg/m^3", "g/cm^3", "lb/in^3">;
inline constexpr auto force = units_named<"N", "lbf">;
inline constexpr auto moment = units_named<"N m", "lbf in">;
inline constexpr auto force_or_moment = units_named<"N", "N m", "lbf", "lbf in">;
inline constexpr auto pressure = units_named<"MPa", "GPa", "Pa", "ksi">;
inline constexpr auto modulus = units_named<"GPa", "MPa", "Pa", "ksi">;
inline constexpr auto spring_rate = units_named<"N/mm", "N/m", "lbf/in", "N m/rad", "N m/deg">;
inline constexpr std::array train_spring = {unit_named<"N/mm">, unit_named<"N/m">, unit_named<"lbf/in">,
                                            with_suffix(unit_named<"N m/rad">, "_n_m_rad"),
                                            unit_named<"N m/rad">};
inline constexpr auto damper = units_named<"N s/m", "N m s/rad">;

// The motion and its derivatives: without a unit normalised, else in time or by the angle of the cam.
inline constexpr auto place = units_named<"", "deg", "rad", "crank deg">;
inline constexpr auto displacement = units_named<"", "mm", "in", "m", "deg", "rad">;
inline constexpr auto velocity = units_named<"", "mm/s", "in/s", "m/s", "deg/s", "rad/s", "mm/rad", "in/rad",
                                             "m/rad", "mm/deg", "in/deg", "deg/deg", "rad/rad">;
inline constexpr auto acceleration =
    units_named<"", "mm/s^2", "in/s^2", "m/s^2", "deg/s^2", "rad/s^2", "mm/rad^2", "in/rad^2", "m/rad^2",
                "mm/deg^2", "in/deg^2", "deg/deg^2", "rad/rad^2">;
inline constexpr auto jerk =
    units_named<"", "mm/s^3", "in/s^3", "m/s^3", "deg/s^3", "rad/s^3", "mm/rad^3", "in/rad^3", "m/rad^3",
                "mm/deg^3", "in/deg^3", "deg/deg^3", "rad/rad^3">;
// Of the motion of a made cam.
inline constexpr auto profile_error = units_named<"um", "mm", "in", "m", "mdeg", "deg", "rad">;
inline constexpr auto slope_error =
    units_named<"um/deg", "mm/deg", "mm/rad", "in/deg", "in/rad", "m/rad", "mdeg/deg", "deg/deg", "rad/rad">;
inline constexpr auto acceleration_error =
    units_named<"um/deg^2", "mm/deg^2", "mm/rad^2", "in/deg^2", "in/rad^2", "m/rad^2", "mdeg/deg^2",
                "deg/deg^2", "rad/rad^2">;
inline constexpr auto ramp_velocity = units_named<"mm/deg", "in/deg", "mm/rad", "in/rad", "deg/deg">;

}  // namespace spellings
}  // namespace camopt
