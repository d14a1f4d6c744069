// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/reciperead.h"

#include "async/virtualclock.h"
#include "experiment/envelope.h"
#include "experiment/experiment.h"
#include "experiment/metrics.h"
#include "experiment/seconds.h"
#include "files/jsonlines.h"
#include "files/qttext.h"
#include "model/device.h"
#include "model/family.h"
#include "model/registry.h"
#include "simulation/simulatedbus.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mb::service {
namespace {

constexpr int mostRepeats = 100;
constexpr double longestTest = 60.0; ///< s
constexpr double anyNumber = 1e12;
constexpr double everyNumber = std::numeric_limits<double>::max();

std::string listed(const std::vector<std::string_view> &words)
{
    std::string all;
    for (const std::string_view word : words)
        all += (all.empty() ? "" : ", ") + std::string(word);
    return all;
}

/// Reads one recipe; stops at the first mistake.
class Reader {
public:
    Reader(JsonLines lines, std::span<const Family *const> families)
        : m_lines(std::move(lines))
        , m_families(families)
    {
    }
    Result<Recipe> read(const QJsonObject &object)
    {
        expect(object, {}, {"recipe", "name", "family", "firmware", "parameters", "number", "test"});
        if (number(object, {}, "recipe", -anyNumber, anyNumber).value_or(0.0) != 1.0)
            wrong("recipe", say("this is no recipe of version 1"), say("it begins with \"recipe\": 1"));
        m_recipe.name = text(object, {}, "name");
        const QString name = qt(m_recipe.name);
        if (std::ranges::any_of(name, [](QChar c) { return c.category() == QChar::Other_Control; }))
            wrong("name", say("a name has no line break, tabulator or other control character"));
        readFamily(object);
        if (m_error)
            return fail(*m_error);
        readFirmware(object);
        readParameters(object);
        readNumber(object);
        readTest(object);
        if (m_error)
            return fail(*m_error);
        return std::move(m_recipe);
    }

private:
    void wrong(const std::string &path, const Message &cause, Message remedy = {})
    {
        if (!m_error)
            m_error = Error{Fault::OutOfRange, atLine(m_lines.of(path), cause), std::move(remedy)};
    }
    static std::string pathOf(const std::string &path, const char *key)
    {
        return path.empty() ? std::string(key) : path + '.' + key;
    }
    void expect(const QJsonObject &object, const std::string &path, const std::vector<std::string_view> &known)
    {
        for (const QString &key : object.keys()) {
            const std::string name = key.toStdString();
            if (std::ranges::find(known, name) == known.end())
                wrong(pathOf(path, name.c_str()), say("unknown key '%1'", name), say("known are %1", listed(known)));
        }
    }
    std::string text(const QJsonObject &object, const std::string &path, const char *key, bool needed = true)
    {
        const QJsonValue value = object.value(QLatin1String(key));
        if (value.isUndefined() && !needed)
            return {};
        if (!value.isString())
            wrong(pathOf(path, key), say("'%1' must be a text", key));
        else if (value.toString().trimmed().isEmpty())
            wrong(pathOf(path, key), say("'%1' must not be empty", key));
        return value.toString().trimmed().toStdString();
    }
    std::optional<double> number(
        const QJsonObject &object, const std::string &path, const char *key, double low, double high)
    {
        const QJsonValue value = object.value(QLatin1String(key));
        if (value.isUndefined())
            return std::nullopt;
        if (!value.isDouble())
            wrong(pathOf(path, key), say("'%1' must be a number", key));
        else if (value.toDouble() < low || value.toDouble() > high)
            wrong(pathOf(path, key), say("%1: legal is %2 … %3", key, low, high));
        else
            return value.toDouble();
        return std::nullopt;
    }
    int whole(const QJsonObject &object, const std::string &path, const char *key, int low, int high, int otherwise)
    {
        const auto value = number(object, path, key, low, high);
        if (value && *value != std::floor(*value))
            wrong(pathOf(path, key), say("'%1' must be a whole number", key));
        return value ? static_cast<int>(*value) : otherwise;
    }
    /// Nothing where it is missing; a mistake where it is something else.
    std::optional<QJsonObject> part(const QJsonObject &object, const std::string &path, const char *key)
    {
        const QJsonValue value = object.value(QLatin1String(key));
        if (value.isUndefined())
            return std::nullopt;
        if (!value.isObject())
            wrong(pathOf(path, key), say("'%1' must be an object in braces", key));
        return value.toObject();
    }

    void readFamily(const QJsonObject &object)
    {
        const std::string key = text(object, {}, "family");
        m_recipe.family = findFamily(m_families, key);
        if (m_recipe.family)
            return;
        std::vector<std::string_view> known;
        for (const Family *const family : m_families)
            known.push_back(family->key);
        wrong("family", say("unknown family '%1'", key), say("this build knows %1", listed(known)));
    }
    void readFirmware(const QJsonObject &object)
    {
        const auto firmware = part(object, {}, "firmware");
        if (!firmware)
            return;
        expect(*firmware, "firmware", {"file", "via"});
        FirmwareRule rule{text(*firmware, "firmware", "file"), text(*firmware, "firmware", "via", false)};
        const Family &family = *m_recipe.family;
        if (!family.update)
            wrong("firmware", say("%1 has no firmware update here", family.key));
        if (family.routes.empty() && !rule.via.empty())
            wrong(
                "firmware.via", say("%1 is updated over its own link", family.key), say("leave the other way in out"));
        const auto leads
            = [&rule](const UpdateRoute &route) { return rule.via.starts_with(std::string(route.scheme) + ':'); };
        if (!family.routes.empty() && std::ranges::none_of(family.routes, leads))
            wrong("firmware.via", say("%1 is not updated over its own link", family.key),
                say("\"via\" must name the other way in, such as \"%1\"", family.routes.front().example));
        m_recipe.firmware = std::move(rule);
    }
    void readParameters(const QJsonObject &object)
    {
        const auto parameters = part(object, {}, "parameters");
        if (!parameters)
            return;
        expect(*parameters, "parameters", {"file", "store"});
        const QJsonValue store = parameters->value(QLatin1String("store"));
        if (!store.isUndefined() && !store.isBool())
            wrong("parameters.store", say("'store' must be true or false"));
        if (store.toBool(false) && !m_recipe.family->capabilities.keepsSettings)
            wrong("parameters.store", say("%1 keeps no setting without power", m_recipe.family->key),
                say("leave 'store' out: its settings are lost with its power"));
        m_recipe.parameters = ParameterRule{text(*parameters, "parameters", "file"), store.toBool(false)};
    }
    void readNumber(const QJsonObject &object)
    {
        const auto rule = part(object, {}, "number");
        if (!rule)
            return;
        expect(*rule, "number", {"first"});
        const Capabilities &can = m_recipe.family->capabilities;
        if (!can.renumber)
            wrong("number", say("%1 has no number that could be set", m_recipe.family->key));
        m_recipe.number = NumberRule{whole(*rule, "number", "first", 1, can.lastAddress, 1)};
    }
    void readTest(const QJsonObject &object)
    {
        const auto test = part(object, {}, "test");
        if (!test)
            return;
        expect(*test, "test", {"loop", "from", "to", "time", "repeat", "axis", "slot", "limits", "accept"});
        SelfTest out;
        const std::string loop = text(*test, "test", "loop");
        if (const auto mode = modeFromString(loop))
            out.loop = *mode;
        else
            wrong("test.loop", say("unknown loop '%1'", loop));
        out.from = number(*test, "test", "from", -anyNumber, anyNumber);
        const auto to = number(*test, "test", "to", -anyNumber, anyNumber);
        if (!to)
            wrong("test.to", say("'to' is missing"), say("the set-point of the step"));
        out.to = to.value_or(0.0);
        const double begin = out.from.value_or(0.0);
        if (to && *to == begin && (out.from || out.loop != Mode::Position)) // a position begins where the unit stands
            wrong("test.to", say("there is no way from %1 to itself", begin), say("give another target"));
        out.seconds = number(*test, "test", "time", 0.001, longestTest);
        out.repeat = whole(*test, "test", "repeat", 1, mostRepeats, 1);
        out.axis = whole(*test, "test", "axis", 1, m_recipe.family->capabilities.axes, 1);
        out.slot = whole(*test, "test", "slot", 0, m_recipe.family->capabilities.gainSlots - 1, 0);
        readLimits(*test, out);
        readAccept(*test, out);
        checkPossible(out);
        m_recipe.test = std::move(out);
    }
    void readLimits(const QJsonObject &test, SelfTest &out)
    {
        const auto limits = part(test, "test", "limits");
        if (!limits)
            return;
        expect(*limits, "test.limits", {"travel", "speed", "current", "duty"});
        for (const EnvelopeBound &bound : envelopeBounds) {
            const auto limit = number(*limits, "test.limits", bound.key, -everyNumber, everyNumber);
            if (const auto bounds = limit ? tuning::checkBound(bound, *limit) : Result<void>(); !bounds)
                wrong(pathOf("test.limits", bound.key), bounds.error().detail, bounds.error().remedy);
            out.limits.*bound.value = limit;
        }
    }
    void readAccept(const QJsonObject &test, SelfTest &out)
    {
        const auto accept = part(test, "test", "accept");
        if (!accept)
            return;
        std::vector<std::string_view> known;
        for (const tuning::MetricKey &metric : tuning::metricKeys())
            known.push_back(metric.key);
        known.insert(known.end(), {figure::resistance, figure::friction, figure::gain, figure::encoder});
        expect(*accept, "test.accept", known);
        for (const QString &key : accept->keys())
            readLimit(key.toStdString(), accept->value(key), out);
    }
    void readLimit(const std::string &key, const QJsonValue &value, SelfTest &out)
    {
        const std::string path = "test.accept." + key;
        const QJsonArray both = value.toArray();
        if (isFigure(key) && m_recipe.family->trials && m_recipe.family->trials->nudge > 0.0)
            wrong(path, say("%1 has no duty command, so '%2' is not measured", m_recipe.family->key, key));
        if (key == figure::encoder) {
            if (!value.isBool() || !value.toBool())
                wrong(path, say("'encoder' is true: it counts both ways"));
            out.accept.push_back({key, std::nullopt, 1.0});
        } else if (value.isDouble() && value.toDouble() >= 0.0) {
            const bool isSigned = key == "sse"; // its size counts
            out.accept.push_back(
                {key, isSigned ? std::optional(-std::abs(value.toDouble())) : std::nullopt, value.toDouble()});
        } else if (both.size() == 2 && both.at(0).isDouble() && both.at(1).isDouble()
            && both.at(0).toDouble() <= both.at(1).toDouble()) {
            out.accept.push_back({key, both.at(0).toDouble(), both.at(1).toDouble()});
        } else {
            wrong(path, say("the limit of '%1' must be the greatest value, 0 or more, or [least, greatest]", key));
        }
    }
    void checkPossible(const SelfTest &test)
    {
        if (m_error)
            return;
        const tuning::ExperimentPlan plan = planOf(test);
        if (auto possible = tuning::checkPlan(*m_recipe.family, plan); !possible)
            return wrong("test", possible.error().detail, possible.error().remedy);
        Envelope limits = test.limits; // those of the unit are known when it is there, and only make them narrower
        limits.duty = std::min(limits.duty.value_or(1.0), 1.0);
        if (test.loop == Mode::Position)
            limits.travel.reset(); // depends on where it stands
        const auto inside = tuning::Stimulus::make(plan.profile, plan.from.value_or(0.0), plan.to, plan.seconds,
            tuning::inSeconds(m_recipe.family->capabilities.commandPeriod))
                                .and_then([&](const tuning::Stimulus &stimulus) {
                                    return tuning::checkInside(limits, plan.mode, stimulus, plan.repeat, 0.0);
                                });
        if (!inside)
            wrong("test.to", inside.error().detail, inside.error().remedy);
        checkReach(test);
    }
    /// By a unit that nobody has found: what it would refuse is refused before anything is written to a real one.
    void checkReach(const SelfTest &test)
    {
        const Family &family = *m_recipe.family;
        VirtualClock clock;
        const auto bus = makeSimulatedBus(family.links.front(), clock, 0, 1);
        const auto end = bus ? (*bus)->makeHost({"sim", std::string(toString(family.links.front())), {}}) : nullptr;
        if (!end)
            return;
        Identity identity;
        identity.family = family.key;
        identity.address = 1;
        const auto unit = family.open(*end, clock, identity);
        SetPoint setPoint;
        setPoint.mode = test.loop;
        setPoint.axis = test.axis;
        setPoint.slot = test.slot;
        for (const auto &[key, target] : {std::pair("from", test.from.value_or(0.0)), std::pair("to", test.to)}) {
            setPoint.target = target;
            if (const auto legal = unit->check(setPoint); !legal && legal.error().fault == Fault::OutOfRange)
                wrong(pathOf("test", key), legal.error().detail, legal.error().remedy);
        }
    }

    JsonLines m_lines;
    std::span<const Family *const> m_families;
    Recipe m_recipe;
    std::optional<Error> m_error;
};

} // namespace

Result<Recipe> parseRecipe(const QByteArray &text, std::span<const Family *const> families)
{
    JsonLines lines = linesOf(text);
    MB_TRY_VOID(lines.checkKeys());
    QJsonParseError mistake;
    const QJsonDocument document = QJsonDocument::fromJson(text, &mistake);
    if (document.isNull())
        return fail(Fault::OutOfRange,
            atLine(lineAt(text, mistake.offset), Message::verbatim(mistake.errorString().toStdString())),
            say("a recipe is a JSON object"));
    if (!document.isObject())
        return fail(Fault::OutOfRange, atLine(1, say("a recipe is a JSON object")), say("it begins with {"));
    return Reader(std::move(lines), families).read(document.object());
}

} // namespace mb::service
