// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "servicebench.h"

#include <cstdio>

namespace mb::service {

inline const QByteArray recipeText = R"({"recipe":1,"name":"drive-base rev C","family":"dmc60c",
"firmware":{"file":"demo.hex"},
"parameters":{"file":"base_c.json"},
"number":{"first":10},
"test":{"loop":"velocity","to":8000,"time":0.8,
"limits":{"travel":400000,"speed":40000,"duty":0.9,"current":60},
"accept":{"settle":0.9,"sse":0.05,"friction":[0.01,1.2],"resistance":[0.02,0.5],"encoder":true}}})";
/// Without the figures of the motor, for tests of the order of things.
inline const QByteArray shortText = R"({"recipe":1,"name":"short","family":"dmc60c",
"firmware":{"file":"demo.hex"},"parameters":{"file":"base_c.json"},"number":{"first":10},
"test":{"loop":"velocity","to":8000,"time":0.8,
"limits":{"travel":400000,"speed":40000,"duty":0.9,"current":60},"accept":{"settle":0.9}}})";

class ServiceQueues : public testing::Test {
protected:
    RecipeMatter load(test::UnitRack &rack, const QByteArray &text = recipeText)
    {
        books.emplace(rack.clock);
        books->write("recipe.json", text);
        QFile::copy(QString::fromStdString(inSourceTree("resources/firmware/dmc60c-demo.hex")),
            QString::fromStdString(books->path("demo.hex")));
        books->write("node.hex", ":060000000C942000FFCF6C\n:00000001FF\n");
        books->write("base_c.json", R"({"family":"dmc60c","parameters":{
"slot1.d":{"raw":77},"current_limit.peak_duration":{"raw":120}}})");
        auto matter = loadRecipe(books->path("recipe.json"), rack.list());
        EXPECT_TRUE(matter) << (matter ? "" : matter.error().text());
        return matter ? *matter : RecipeMatter{};
    }
    static void print(const std::vector<Visit> &visits)
    {
        for (const Visit &v : visits)
            std::printf("  %s %s at %s, %s -> %s, number %d, %.1f s: %s | %s\n", v.serial.c_str(),
                std::string(toString(v.outcome)).c_str(), std::string(toString(v.step)).c_str(), v.from.c_str(),
                v.to.c_str(), v.number.value_or(-1), v.seconds, v.cause.english().c_str(), v.remedy.english().c_str());
    }
    std::optional<test::ServiceBooks> books;
};

} // namespace mb::service
