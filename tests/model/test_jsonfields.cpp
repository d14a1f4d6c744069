// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/jsonfields.h"

#include <gtest/gtest.h>

#include <QJsonDocument>

#include <cstdint>
#include <map>
#include <set>

namespace mb {
namespace sample {

enum class Colour { Red, Blue };
std::string_view toString(Colour colour)
{
    return colour == Colour::Red ? "red" : "blue";
}

struct Part {
    double size = 1.0;
    std::optional<double> weight;
    friend bool operator==(const Part &, const Part &) = default;
};
struct Whole {
    bool isNew = true;
    int count = 3;
    QString title;
    Colour colour = Colour::Red;
    std::optional<Part> spare;
    std::string note;
    std::vector<Part> parts;
    std::set<std::string> tags;
    std::map<std::string, std::int64_t> stock;
    std::vector<std::pair<std::string, std::optional<double>>> prices;
    friend bool operator==(const Whole &, const Whole &) = default;
};

} // namespace sample

using sample::Part;
using sample::Whole;

template <> const JsonFields<Part> jsonFields<Part>{{"size", &Part::size}, {"weight", &Part::weight}};
template <>
const JsonFields<Whole> jsonFields<Whole>{{"new", &Whole::isNew}, {"count", &Whole::count}, {"title", &Whole::title},
    {"colour", &Whole::colour, {sample::Colour::Red, sample::Colour::Blue}}, {"spare", &Whole::spare, ifSet},
    {"note", &Whole::note, ifSet}, {"parts", &Whole::parts}, {"tags", &Whole::tags}, {"stock", &Whole::stock},
    {"prices", &Whole::prices}};

namespace {

QByteArray textOf(const Whole &whole)
{
    return QJsonDocument(toJson(whole)).toJson(QJsonDocument::Compact);
}

bool read(const char *text, Whole &whole)
{
    return fromJson(QJsonDocument::fromJson(text).object(), whole);
}

TEST(JsonFields, WriteAStructureUnderItsKeysAndReadItBack)
{
    const Whole whole{false, 7, QStringLiteral("ü"), sample::Colour::Blue, Part{2.5, 4.0}, "n", {{1.0, {}}, {2.0, 3.0}},
        {"a", "b"}, {{"x", -9007199254740992}}, {{"p", 1.5}, {"q", {}}}};
    EXPECT_EQ(textOf(whole),
        R"({"colour":"blue","count":7,"new":false,"note":"n","parts":[{"size":1,"weight":null},{"size":2,"weight":3}],)"
        R"("prices":{"p":1.5,"q":null},"spare":{"size":2.5,"weight":4},"stock":{"x":-9007199254740992},)"
        R"("tags":["a","b"],"title":"ü"})");
    Whole back;
    EXPECT_TRUE(read(textOf(whole), back));
    EXPECT_EQ(back, whole);
}

TEST(JsonFields, LeaveOutWhatIsAsInANewStructureWhereThatIsSaid)
{
    EXPECT_EQ(
        textOf({}), R"({"colour":"red","count":3,"new":true,"parts":[],"prices":{},"stock":{},"tags":[],"title":""})");
}

TEST(JsonFields, WriteANumberThatIsNotFiniteAsNull)
{
    Whole whole;
    whole.parts = {{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}};
    EXPECT_TRUE(textOf(whole).contains(R"([{"size":null,"weight":null}])"));
}

TEST(JsonFields, ReadTheRestWhereSomethingIsMissingOrOfAnotherKindAndTellTheLatter)
{
    Whole whole;
    EXPECT_TRUE(read(R"({"count": 4, "unknown": 1})", whole));
    EXPECT_EQ(whole.count, 4);
    for (const char *text :
        {R"({"new": 1})", R"({"count": 1.5})", R"({"count": 3000000000})", R"({"title": null})", R"({"count": null})",
            R"({"colour": "green"})", R"({"spare": 1})", R"({"parts": {}})", R"({"stock": {"x": 9007199254740994}})"}) {
        Whole same = whole;
        EXPECT_FALSE(read(text, same)) << text;
        EXPECT_EQ(same, whole) << text;
    }
    EXPECT_FALSE(read(R"({"parts": [1, {"size": 5, "weight": "heavy"}], "prices": {"a": true, "b": 2}})", whole));
    EXPECT_EQ(whole.parts, (std::vector<Part>{{5.0, {}}}));
    EXPECT_EQ(whole.prices.size(), 1U);
}

} // namespace
} // namespace mb
