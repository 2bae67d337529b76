#pragma once

#include "bem_contact/base/schema.hpp"

namespace bem_contact {

/// "c" of "a.b.c", and "a.b" ("" where there is no table).
std::string last_part(std::string_view path);
std::string table_of(std::string_view path);

/// A bound value as TOML, and its type in words.
std::string value_text(const SchemaTarget& target);
KeyType key_type(const SchemaTarget& target);
/// The bound value; nothing of an empty optional and of a list of tables.
std::optional<SchemaValue> plain_value(const SchemaTarget& target);
std::string type_text(const SchemaTarget& target);

/// "> 0 and <= 1", "a | b"; "" if any value is allowed.
std::string range_text(const SchemaTarget& target, const KeyRule& rule);

/// A text as TOML writes it, with its quotes.
std::string toml_text(std::string_view text);

} // namespace bem_contact
