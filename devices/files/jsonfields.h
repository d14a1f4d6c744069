// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "files/qttext.h"

#include <QJsonArray>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace mb {

template <class T> class JsonField;
template <class T> using JsonFields = std::vector<JsonField<T>>;

/// How a structure stands in a JSON object: its members under their keys, told once for writing and reading.
///
///     template <> const JsonFields<Row> jsonFields<Row>{{"key", &Row::key}, {"note", &Row::note, ifSet}};
///
/// Structures in it are told before it. A type that stands otherwise has functions toJson() and fromJson() of its own.
template <class T> extern const JsonFields<T> jsonFields;

/// A structure and names with values are objects, a list is an array; nothing is null, and so is a number that is not finite.
template <class T> auto toJson(const T &value);
/// The same back. What is missing or of another kind stays as it was, but a truth is false, and an optional nothing; in lists and
/// objects it is left out. Yields false where something was of another kind.
template <class T> bool fromJson(const QJsonValue &json, T &value);

enum IfSet { ifSet }; ///< a field is left out where it is as in a new structure

template <class T> class JsonField {
public:
    using Write = std::function<QJsonValue(const T &)>;        ///< yields Undefined: it is left out
    using Read = std::function<bool(const QJsonValue &, T &)>; ///< of Undefined where it is missing

    JsonField(std::string_view key, Write write, Read read)
        : m_key(qt(key))
        , m_write(std::move(write))
        , m_read(std::move(read))
    {
    }
    template <class M>
    JsonField(std::string_view key, M T::*member)
        : JsonField(
            key, [member](const T &value) { return toJson(value.*member); },
            [member](const QJsonValue &json, T &value) { return fromJson(json, value.*member); })
    {
    }
    template <class M>
    JsonField(std::string_view key, M T::*member, IfSet)
        : JsonField(key, member)
    {
        m_write = [member](const T &value) {
            const QJsonValue json = toJson(value.*member);
            return json == QJsonValue(toJson(T().*member)) ? QJsonValue(QJsonValue::Undefined) : json;
        };
    }
    /// An enumerator by its word, which toString() has; of these.
    template <class E>
    JsonField(std::string_view key, E T::*member, std::initializer_list<E> all)
        : JsonField(
            key, [member](const T &value) { return qt(toString(value.*member)); },
            [member, all = std::vector<E>(all)](const QJsonValue &json, T &value) {
                for (const E each : all) {
                    if (qt(toString(each)) == json.toString()) {
                        value.*member = each;
                        return true;
                    }
                }
                return false;
            })
    {
    }

    void write(const T &value, QJsonObject &object) const { object.insert(m_key, m_write(value)); }
    bool read(const QJsonObject &object, T &value) const
    {
        const QJsonValue json = object.value(m_key);
        return m_read(json, value) || json.isUndefined();
    }

private:
    QString m_key;
    Write m_write;
    Read m_read;
};

/// One for each row of a table of keys and members.
template <class T, class Rows> JsonFields<T> jsonFieldsOf(const Rows &rows)
{
    JsonFields<T> fields;
    for (const auto &row : rows)
        fields.emplace_back(row.key, row.value);
    return fields;
}

template <class T>
concept JsonText = std::is_same_v<T, QString> || std::is_convertible_v<T, std::string_view>;
template <class T>
concept JsonOptional = std::is_same_v<T, std::optional<typename T::value_type>>;
template <class T>
concept JsonNames = sizeof(typename T::value_type::second_type) > 0;
template <class T>
concept JsonList = !JsonText<T> && !JsonNames<T> && sizeof(typename T::iterator) > 0;

template <class T> auto toJson(const T &value)
{
    if constexpr (std::is_same_v<T, bool>) {
        return QJsonValue(value);
    } else if constexpr (std::is_arithmetic_v<T>) {
        const auto number = static_cast<double>(value);
        return std::isfinite(number) ? QJsonValue(number) : QJsonValue();
    } else if constexpr (std::is_same_v<T, QString>) {
        return value;
    } else if constexpr (JsonText<T>) {
        return qt(value);
    } else if constexpr (JsonOptional<T>) {
        return value ? QJsonValue(toJson(*value)) : QJsonValue();
    } else if constexpr (JsonNames<T>) {
        QJsonObject object;
        for (const auto &[name, each] : value)
            object.insert(toJson(name), toJson(each));
        return object;
    } else if constexpr (JsonList<T>) {
        QJsonArray array;
        for (const auto &each : value)
            array.append(toJson(each));
        return array;
    } else {
        QJsonObject object;
        for (const JsonField<T> &field : jsonFields<T>)
            field.write(value, object);
        return object;
    }
}

constexpr double greatestWhole = 9007199254740992.0; ///< up to here every whole number is a JSON number

template <class T> bool isWholeIn(double number)
{
    constexpr double most = std::min(greatestWhole, static_cast<double>(std::numeric_limits<T>::max()));
    return number == std::floor(number) && std::abs(number) <= most;
}

/// Nothing where it is of another kind; of a structure what is right of it.
template <class T> std::optional<T> readJson(const QJsonValue &json, bool &isRight)
{
    std::optional<T> value{std::in_place};
    const bool isWhole = fromJson(json, *value);
    isRight = isRight && isWhole;
    return isWhole || (json.isObject() && std::is_class_v<T> && !JsonText<T>) ? std::move(value) : std::nullopt;
}

template <class T> bool readList(const QJsonValue &json, T &list)
{
    bool isRight = json.isArray();
    if (isRight)
        list.clear();
    for (const QJsonValue each : json.toArray()) {
        if (auto read = readJson<typename T::value_type>(each, isRight))
            list.insert(list.end(), std::move(*read));
    }
    return isRight;
}

template <class T> bool readNames(const QJsonValue &json, T &names)
{
    bool isRight = json.isObject();
    if (isRight)
        names.clear();
    const QJsonObject object = json.toObject();
    for (auto each = object.begin(); each != object.end(); ++each) {
        std::remove_const_t<typename T::value_type::first_type> name;
        fromJson(QJsonValue(each.key()), name);
        if (auto read = readJson<typename T::value_type::second_type>(each.value(), isRight))
            names.insert(names.end(), {std::move(name), std::move(*read)});
    }
    return isRight;
}

template <class T> bool fromJson(const QJsonValue &json, T &value)
{
    if constexpr (std::is_same_v<T, bool>) {
        value = json.toBool();
        return json.isBool();
    } else if constexpr (std::is_arithmetic_v<T>) {
        const double number = json.toDouble();
        const bool isRight = json.isDouble() && (std::is_floating_point_v<T> || isWholeIn<T>(number));
        value = isRight ? static_cast<T>(number) : value;
        return isRight;
    } else if constexpr (std::is_same_v<T, QString>) {
        value = json.toString(value);
        return json.isString();
    } else if constexpr (std::is_same_v<T, std::string>) {
        value = json.isString() ? json.toString().toStdString() : value;
        return json.isString();
    } else if constexpr (JsonOptional<T>) {
        bool isRight = true;
        value = readJson<typename T::value_type>(json, isRight);
        return isRight || json.isNull();
    } else if constexpr (JsonNames<T>) {
        return readNames(json, value);
    } else if constexpr (JsonList<T>) {
        return readList(json, value);
    } else {
        bool isRight = json.isObject();
        const QJsonObject object = json.toObject();
        for (const JsonField<T> &field : jsonFields<T>)
            isRight = field.read(object, value) && isRight;
        return isRight;
    }
}

} // namespace mb
