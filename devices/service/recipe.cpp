// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/recipe.h"

#include "experiment/envelope.h"
#include "experiment/experiment.h"
#include "experiment/metrics.h"
#include "files/qttext.h"
#include "model/family.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>

namespace mb::service {
namespace {

constexpr std::array motorKeys{figure::resistance, figure::friction, figure::gain, figure::encoder};

QJsonObject acceptOf(const std::vector<Acceptance> &accept)
{
    QJsonObject object;
    for (const Acceptance &one : accept) {
        QJsonValue value(one.high);
        if (one.key == figure::encoder)
            value = true;
        else if (one.low)
            value = QJsonArray{*one.low, one.high};
        object.insert(qt(one.key), value);
    }
    return object;
}

QJsonObject testOf(const SelfTest &test)
{
    QJsonObject object{{QStringLiteral("loop"), qt(toString(test.loop))}, {QStringLiteral("to"), test.to},
        {QStringLiteral("repeat"), test.repeat}, {QStringLiteral("axis"), test.axis},
        {QStringLiteral("slot"), test.slot}, {QStringLiteral("limits"), tuning::limitsToJson(test.limits)},
        {QStringLiteral("accept"), acceptOf(test.accept)}};
    if (test.from)
        object.insert(QStringLiteral("from"), *test.from);
    if (test.seconds)
        object.insert(QStringLiteral("time"), *test.seconds);
    return object;
}

} // namespace

tuning::ExperimentPlan planOf(const SelfTest &test)
{
    tuning::ExperimentPlan plan;
    plan.mode = test.loop;
    plan.axis = test.axis;
    plan.slot = test.slot;
    plan.from = test.from;
    plan.to = test.to;
    plan.seconds = test.seconds;
    plan.repeat = test.repeat;
    return plan;
}

bool isFigure(std::string_view key)
{
    return std::ranges::find(motorKeys, key) != motorKeys.end();
}

QByteArray toText(const Recipe &recipe)
{
    QJsonObject object{{QStringLiteral("recipe"), 1}, {QStringLiteral("name"), qt(recipe.name)},
        {QStringLiteral("family"), qt(recipe.family->key)}};
    if (recipe.firmware) {
        QJsonObject firmware{{QStringLiteral("file"), qt(recipe.firmware->file)}};
        if (!recipe.firmware->via.empty())
            firmware.insert(QStringLiteral("via"), qt(recipe.firmware->via));
        object.insert(QStringLiteral("firmware"), firmware);
    }
    if (recipe.parameters)
        object.insert(QStringLiteral("parameters"),
            QJsonObject{{QStringLiteral("file"), qt(recipe.parameters->file)},
                {QStringLiteral("store"), recipe.parameters->store}});
    if (recipe.number)
        object.insert(QStringLiteral("number"), QJsonObject{{QStringLiteral("first"), recipe.number->first}});
    if (recipe.test)
        object.insert(QStringLiteral("test"), testOf(*recipe.test));
    return QJsonDocument(object).toJson(QJsonDocument::Indented);
}

} // namespace mb::service
