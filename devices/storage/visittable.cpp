// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/visittable.h"

#include "files/qttext.h"
#include "storage/messagejson.h"
#include "storage/sqltext.h"
#include "storage/visitjson.h"

#include <QJsonDocument>
#include <QSqlQuery>

#include <map>

namespace mb {
namespace {

using service::StepEntry;
using service::Visit;

constexpr const char *visitColumns
    = "id, revision, run, time, station, person, recipe, recipe_hash, image_hash, unit, "
      "serial, device, family, simulated, "
      "step, outcome, firmware_before, firmware_after, parameters, test, number, snapshot, "
      "trial, seconds, cause, remedy, "
      "evidence, note, ending, unproved";

template <class Number> QVariant sqlOrNull(const std::optional<Number> &number)
{
    return number ? QVariant(static_cast<qlonglong>(*number)) : QVariant(QVariant::LongLong);
}

template <class Number> std::optional<Number> countAt(const QSqlQuery &row, int column)
{
    const QVariant value = row.value(column);
    return value.isNull() ? std::nullopt : std::optional(static_cast<Number>(value.toLongLong()));
}

QString testText(const std::vector<service::TestValue> &test)
{
    return QString::fromUtf8(QJsonDocument(testToJson(test)).toJson(QJsonDocument::Compact));
}

QVariantList visitValues(const KeptVisit &kept)
{
    const Visit &v = kept.visit;
    return {qt(v.id), static_cast<qlonglong>(kept.revision), qt(v.run), v.time, qt(v.station), qt(v.person),
        qt(v.recipe), qt(v.recipeHash), qt(v.imageHash), qt(v.unit), qt(v.serial), qt(v.device), qt(v.family),
        v.simulated ? 1 : 0, qt(toString(v.step)), qt(toString(v.outcome)), qt(v.from), qt(v.to),
        sqlOrNull(v.parameters), testText(v.test), sqlOrNull(v.number), sqlOrNull(v.snapshot), sqlOrNull(v.trial),
        v.seconds, savedText(v.cause), savedText(v.remedy), savedText(v.evidence), qt(v.note), qt(toString(v.ending)),
        v.unproved ? 1 : 0};
}

KeptVisit visitFrom(const QSqlQuery &row)
{
    KeptVisit kept;
    Visit &v = kept.visit;
    kept.revision = row.value(1).toLongLong();
    v.id = textAt(row, 0);
    v.run = textAt(row, 2);
    v.time = row.value(3).toDouble();
    v.station = textAt(row, 4);
    v.person = textAt(row, 5);
    v.recipe = textAt(row, 6);
    v.recipeHash = textAt(row, 7);
    v.imageHash = textAt(row, 8);
    v.unit = textAt(row, 9);
    v.serial = textAt(row, 10);
    v.device = textAt(row, 11);
    v.family = textAt(row, 12);
    v.simulated = row.value(13).toInt() != 0;
    v.step = service::stepFromString(textAt(row, 14));
    v.outcome = service::outcomeFromString(textAt(row, 15));
    v.from = textAt(row, 16);
    v.to = textAt(row, 17);
    v.parameters = countAt<int>(row, 18);
    v.test = testFromJson(QJsonDocument::fromJson(row.value(19).toString().toUtf8()).array());
    v.number = countAt<int>(row, 20);
    v.snapshot = countAt<std::int64_t>(row, 21);
    v.trial = countAt<std::int64_t>(row, 22);
    v.seconds = row.value(23).toDouble();
    v.cause = messageFrom(textAt(row, 24));
    v.remedy = messageFrom(textAt(row, 25));
    v.evidence = messageFrom(textAt(row, 26));
    v.note = textAt(row, 27);
    v.ending = service::endingFromString(textAt(row, 28));
    v.unproved = row.value(29).toInt() != 0;
    return kept;
}

/// In one statement: a server takes its time for each.
Result<void> putSteps(SqlConnection &sql, const Visit &visit)
{
    QVariantList values;
    std::string rows;
    for (const StepEntry &entry : visit.steps) {
        rows += rows.empty() ? "(?, ?, ?, ?, ?, ?)" : ", (?, ?, ?, ?, ?, ?)";
        values << qt(visit.id) << values.size() / 6 << qt(toString(entry.step)) << entry.time << (entry.ended ? 1 : 0)
               << savedText(entry.detail);
    }
    if (rows.empty())
        return {};
    return sql.run(("INSERT INTO service_step (visit, place, step, time, ended, detail) VALUES " + rows
                       + " ON CONFLICT (visit, place) DO NOTHING")
                       .c_str(),
        values);
}

/// All but the id are taken from what is put.
const std::string &putStatement()
{
    static const std::string statement = [] {
        const QStringList names = QString::fromUtf8(visitColumns).split(QStringLiteral(", "));
        QStringList marks;
        QStringList changes;
        for (const QString &name : names) {
            marks += QStringLiteral("?");
            if (name != QLatin1String("id"))
                changes += name + QStringLiteral(" = excluded.") + name;
        }
        const QString text
            = QStringLiteral("INSERT INTO service_visit (%1) VALUES (%2) ON CONFLICT (id) DO UPDATE SET %3 "
                             "WHERE service_visit.revision <= excluded.revision");
        return text
            .arg(QString::fromUtf8(visitColumns), marks.join(QStringLiteral(", ")), changes.join(QStringLiteral(", ")))
            .toStdString();
    }();
    return statement;
}

Result<std::vector<KeptVisit>> select(
    SqlConnection &sql, const std::string &rest, const QVariantList &values, bool withSteps = true)
{
    std::vector<KeptVisit> visits;
    auto read = sql.run(("SELECT " + std::string(visitColumns) + " FROM service_visit " + rest).c_str(), values,
        [&visits](const QSqlQuery &row) { visits.push_back(visitFrom(row)); });
    std::map<std::string, Visit *> byId;
    for (KeptVisit &kept : visits)
        byId[kept.visit.id] = &kept.visit;
    const std::string steps = "SELECT step, time, ended, detail, visit FROM service_step WHERE visit IN "
                              "(SELECT id FROM service_visit "
        + rest + ") ORDER BY visit, place";
    if (read && withSteps && !visits.empty())
        read = sql.run(steps.c_str(), values, [&byId](const QSqlQuery &row) {
            if (const auto found = byId.find(textAt(row, 4)); found != byId.end())
                found->second->steps.push_back({service::stepFromString(textAt(row, 0)), row.value(1).toDouble(),
                    row.value(2).toInt() != 0, messageFrom(textAt(row, 3))});
        });
    if (!read)
        return fail(read.error());
    return visits;
}

} // namespace

Result<void> putVisit(SqlConnection &sql, const KeptVisit &kept)
{
    auto put = sql.run(putStatement().c_str(), visitValues(kept));
    return put ? putSteps(sql, kept.visit) : put;
}

Result<void> putVisits(SqlConnection &sql, const std::vector<KeptVisit> &visits)
{
    return sql.transact([&]() -> Result<void> {
        for (const KeptVisit &kept : visits)
            MB_TRY_VOID(putVisit(sql, kept));
        return {};
    });
}

Result<std::vector<KeptVisit>> getVisits(SqlConnection &sql, const service::VisitFilter &filter)
{
    std::string where;
    QVariantList values;
    const auto add = [&where, &values](const char *condition, const QVariant &value) {
        where += (where.empty() ? "WHERE " : " AND ") + std::string(condition);
        values += value;
    };
    const std::pair<const char *, const std::string *> texts[]
        = {{"recipe = ?", &filter.recipe}, {"recipe_hash = ?", &filter.recipeHash}, {"run = ?", &filter.run},
            {"station = ?", &filter.station}, {"unit = ?", &filter.unit}, {"serial = ?", &filter.serial}};
    for (const auto &[condition, text] : texts) {
        if (!text->empty())
            add(condition, qt(*text));
    }
    if (filter.since)
        add("time >= ?", *filter.since);
    if (filter.outcome)
        add("outcome = ?", qt(toString(*filter.outcome)));
    if (filter.simulated)
        add("simulated = ?", *filter.simulated ? 1 : 0);
    if (filter.newest > 0)
        where = "WHERE id IN (SELECT id FROM service_visit " + where + " ORDER BY time DESC, id DESC LIMIT "
            + std::to_string(filter.newest) + ')';
    return select(sql, where + " ORDER BY time, id", values, filter.steps);
}

Result<KeptVisit> getVisit(SqlConnection &sql, const std::string &id)
{
    MB_TRY(auto found, select(sql, "WHERE id = ?", {qt(id)}));
    if (found.empty())
        return fail(Fault::OutOfRange, say("there is no entry %1 in the journal", id));
    return std::move(found.front());
}

namespace {

/// Simulated units concern nobody else.
constexpr const char *notAt = "WHERE simulated = 0 AND NOT EXISTS (SELECT 1 FROM service_delivery WHERE "
                              "service_delivery.visit = service_visit.id AND "
                              "service_delivery.revision = service_visit.revision AND service_delivery.server = ?)";

} // namespace

Result<std::vector<KeptVisit>> undelivered(SqlConnection &sql, const std::string &server, int most)
{
    return select(sql, std::string(notAt) + " ORDER BY time, id LIMIT ?", {qt(server), most});
}

Result<int> countUndelivered(SqlConnection &sql, const std::string &server)
{
    int count = 0;
    MB_TRY_VOID(sql.run(("SELECT count(*) FROM service_visit " + std::string(notAt)).c_str(), {qt(server)},
        [&count](const QSqlQuery &row) { count = row.value(0).toInt(); }));
    return count;
}

Result<void> markDelivered(SqlConnection &sql, const std::string &server, const std::vector<KeptVisit> &visits)
{
    return sql.transact([&]() -> Result<void> {
        for (const KeptVisit &kept : visits) {
            MB_TRY_VOID(sql.run("INSERT INTO service_delivery (visit, server, revision) VALUES (?, ?, ?) "
                                "ON CONFLICT (visit, server) DO UPDATE SET revision = excluded.revision",
                {qt(kept.visit.id), qt(server), static_cast<qlonglong>(kept.revision)}));
        }
        return {};
    });
}

} // namespace mb
