// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/filebytes.h"
#include "model/parameterfile.h"
#include "support/simulatedsession.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QTemporaryDir>

namespace mb {
namespace {

const Family &family()
{
    return *findFamily(families(), "dmc60c");
}

QByteArray file(const QByteArray &rows, const QByteArray &name = "dmc60c")
{
    return "{\"family\":\"" + name
        + "\",\"device\":\"sim:can/dmc60c:5\",\"serial\":\"S\",\"firmware\":null,\"parameters\":{" + rows + "}}";
}

std::int64_t taken(const ParameterFile &parsed, std::string_view key)
{
    for (const ParameterChange &change : parsed.values) {
        if (family().parameters[change.index.value].key == key)
            return change.raw;
    }
    ADD_FAILURE() << key << " was not taken";
    return 0;
}

TEST(ParameterFile, TakesValuesAndRawValuesInTableOrder)
{
    const auto parsed = parseParameterFile(
        file("\"slot0.i\":{\"raw\":32768},\"current_limit.enabled\":{\"value\":true},\"slot0.p\":{\"value\":1.5}"),
        family());
    ASSERT_TRUE(parsed) << parsed.error().text();
    ASSERT_EQ(parsed->values.size(), 3U);
    EXPECT_TRUE(std::is_sorted(parsed->values.begin(), parsed->values.end(),
        [](const ParameterChange &a, const ParameterChange &b) { return a.index < b.index; }));
    EXPECT_EQ(taken(*parsed, "slot0.p"), 98304);
    EXPECT_EQ(taken(*parsed, "slot0.i"), 32768);
    EXPECT_EQ(taken(*parsed, "current_limit.enabled"), 1);
    EXPECT_EQ(parsed->device, "sim:can/dmc60c:5");
    EXPECT_TRUE(parsed->firmware.empty());
}

TEST(ParameterFile, RefusesAValueThatWasEditedBesideItsRawValue)
{
    const auto parsed = parseParameterFile(file("\"slot0.p\":{\"raw\":65536,\"value\":1.5}"), family());
    ASSERT_FALSE(parsed);
    EXPECT_EQ(
        parsed.error().text(), "slot0.p: its value says 1.5, its raw value 1; delete the one of the two that is old");
    const auto agreeing = parseParameterFile(file("\"slot0.p\":{\"raw\":98304,\"value\":1.5}"), family());
    ASSERT_TRUE(agreeing);
    EXPECT_EQ(taken(*agreeing, "slot0.p"), 98304);
}

TEST(ParameterFile, RefusesARawValueThatNoIntegerCanHold)
{
    for (const char *const raw : {"1e30", "-1e30", "9223372036854775808", "2147483648"}) {
        const auto parsed = parseParameterFile(file(QByteArray("\"slot0.p\":{\"raw\":") + raw + "}"), family());
        ASSERT_FALSE(parsed) << raw;
        EXPECT_NE(parsed.error().text().find("out of range"), std::string::npos) << parsed.error().text();
    }
}

TEST(ParameterFile, RefusesAKeyThatIsThereTwice)
{
    const auto parsed = parseParameterFile(file("\n\"slot0.p\":{\"value\":1},\n\"slot0.p\":{\"value\":2}"), family());
    ASSERT_FALSE(parsed);
    EXPECT_EQ(parsed.error().text(), "line 3: the key 'parameters.slot0.p' is there twice");
    EXPECT_FALSE(parseParameterFile(file("\"slot0.p\":{\"value\":1,\"value\":2}"), family()));
    EXPECT_TRUE(parseParameterFile(file("\"slot0.p\":{\"value\":1},\"slot1.p\":{\"value\":2}"), family()));
}

TEST(ParameterFile, RefusesAValueInAnotherUnitThanItsParameters)
{
    const auto parsed
        = parseParameterFile(file("\"current_limit.p\":{\"value\":100,\"unit\":\"throttle/mA\"}"), family());
    ASSERT_FALSE(parsed);
    EXPECT_EQ(parsed.error().fault, Fault::OutOfRange);
    EXPECT_EQ(parsed.error().text(),
        "current_limit.p: its value is in 'throttle/mA', its unit is 'throttle/A'; write it in that unit");
    EXPECT_TRUE(parseParameterFile(file("\"current_limit.p\":{\"value\":100,\"unit\":\"throttle/A\"}"), family()));
    EXPECT_TRUE(parseParameterFile(file("\"current_limit.p\":{\"value\":100,\"unit\":null}"), family()))
        << "names none";
}

TEST(ParameterFile, NotesWhatItLeavesOut)
{
    const auto parsed = parseParameterFile(file("\"slot0.p\":{\"raw\":null,\"value\":null}"), family());
    ASSERT_TRUE(parsed);
    EXPECT_TRUE(parsed->values.empty());
    EXPECT_EQ(parsed->notes.size(), 1U);
}

TEST(ParameterFile, RefusesAKeyThatNobodyKnowsAndNamesIt)
{
    const auto parsed = parseParameterFile(file("\"slot0.p\":{\"raw\":1},\"no.such\":{\"raw\":1}"), family());
    ASSERT_FALSE(parsed);
    EXPECT_EQ(parsed.error().text(), "unknown key no.such; correct it, or delete its row");
    const auto misspelt = parseParameterFile(file("\"slot0.p\":{\"valeu\":1}"), family());
    ASSERT_FALSE(misspelt);
    EXPECT_EQ(misspelt.error().text(), "slot0.p: unknown key valeu; write \"value\" or \"raw\"");
}

TEST(ParameterFile, RefusesTheWholeFileForOneBadRow)
{
    const QByteArray good = "\"slot0.i\":{\"raw\":1},";
    for (const char *row : {"\"slot0.p\":{\"value\":1e9}", "\"slot0.p\":{\"raw\":1e300}", "\"slot0.p\":{\"raw\":1.5}",
             "\"slot0.p\":{\"raw\":-99999999999}", "\"slot0.p\":{\"value\":\"1\"}", "\"slot0.p\":{\"value\":true}",
             "\"current_limit.enabled\":{\"value\":1}", "\"current_limit.enabled\":{\"raw\":2}", "\"slot0.p\":7",
             "\"slot0.p\":[]", "\"slot0.p\":{\"raw\":\"abc\",\"value\":1}", "\"slot0.p\":{\"raw\":1,\"value\":\"abc\"}",
             "\"slot0.p\":{\"raw\":\"x\",\"value\":{}}"}) {
        const auto parsed = parseParameterFile(file(good + row), family());
        ASSERT_FALSE(parsed) << row;
        EXPECT_EQ(parsed.error().fault, Fault::OutOfRange) << row;
        EXPECT_FALSE(parsed.error().text().empty());
        EXPECT_EQ(parsed.error().text().find('\n'), std::string::npos);
    }
}

TEST(ParameterFile, RefusesWhatIsNoParameterFileOfThisFamily)
{
    for (const QByteArray &bytes : {QByteArray(), QByteArray("nonsense"), QByteArray("[]"), QByteArray("{}"),
             QByteArray("{\"family\":\"dmc60c\"}"), QByteArray("{\"family\":\"dmc60c\",\"parameters\":[]}"),
             file("", "supermodified"), file("").chopped(1), QByteArray("\0\xFF\xFE", 3),
             QByteArray("{\"family\":5,\"parameters\":{}}")}) {
        const auto parsed = parseParameterFile(bytes, family());
        ASSERT_FALSE(parsed) << bytes.constData();
        EXPECT_EQ(parsed.error().fault, Fault::OutOfRange);
        EXPECT_EQ(parsed.error().text().find('\n'), std::string::npos);
    }
    EXPECT_EQ(familyOf(file("", "supermodified")), "supermodified");
    EXPECT_FALSE(familyOf("{\"family\":5}"));
    EXPECT_FALSE(familyOf("nonsense"));
    EXPECT_FALSE(familyOf("{\"family\":\"supermodified\",\"family\":\"dmc60c\"}")) << "one of the two";
}

TEST(ParameterFile, ComesBackAsItWasSaved)
{
    test::SimulatedSession bench;
    bench.scan();
    Device &device = *bench.device(5);
    NoProgress progress;
    ASSERT_TRUE(test::run(bench.clock, readParameters(device, readable(device), progress)));
    const QByteArray saved = QJsonDocument(parametersToJson(device, readable(device))).toJson();
    const auto parsed = parseParameterFile(saved, device.family());
    ASSERT_TRUE(parsed) << parsed.error().text();
    EXPECT_EQ(parsed->values.size(), readable(device).size());
    for (const ParameterChange &change : parsed->values)
        EXPECT_EQ(change.raw, device.parameters().entry(change.index).raw)
            << device.parameters().parameter(change.index).key;
    EXPECT_TRUE(differences(device, *parsed).empty());
}

TEST(ParameterFile, RestoresSettingsOnlyThatDifferAndSurviveAPowerCycle)
{
    test::SimulatedSession bench;
    bench.scan();
    Device &device = *bench.device(5);
    ParameterFile all;
    for (const ParameterIndex index : readable(device)) {
        const Parameter &p = device.parameters().parameter(index);
        device.parameters().setRead(index, 0);
        all.values.push_back({index, p.maximum > 0.0 ? 1 : 0});
    }
    const auto wanted = differences(device, all);
    EXPECT_FALSE(wanted.empty());
    for (const ParameterDifference &difference : wanted) {
        const Parameter &p = device.parameters().parameter(difference.index);
        EXPECT_TRUE(p.persistent && p.access != Access::ReadOnly && p.nature == Nature::Setting) << p.key;
        EXPECT_EQ(difference.from, 0);
    }
    device.parameters().setFailed(wanted.front().index);
    EXPECT_FALSE(differences(device, all).front().from) << "what was not read is not known";
}

TEST(ParameterFile, TellsWhatBelongsToTheUnitThatItWasSavedFrom)
{
    test::SimulatedSession bench;
    bench.scan();
    Device &device = *bench.device(5);
    const auto index = *findParameter(device.family().parameters, "current.adc_multiplier");
    device.parameters().setRead(index, 2070);
    ParameterFile saved;
    saved.serial = device.identity().serial;
    saved.values.push_back({index, 2100});
    ASSERT_FALSE(saved.serial.empty());
    EXPECT_FALSE(differences(device, saved).front().ofAnotherUnit) << "a backup of the unit itself";
    saved.serial = "of another one";
    EXPECT_TRUE(differences(device, saved).front().ofAnotherUnit);
    saved.serial.clear();
    EXPECT_TRUE(differences(device, saved).front().ofAnotherUnit) << "nobody knows from where";
}

TEST(ParameterFile, RestoresWhatCannotBeReadWhateverIsAssumedOfIt)
{
    test::SimulatedSession bench;
    bench.scan();
    const std::vector<Device *> drives = bench.devices("abstractdc");
    ASSERT_FALSE(drives.empty());
    Device &device = *drives.front();
    const auto index = *findParameter(device.family().parameters, "velocity.p");
    device.parameters().setWritten(index, 77);
    ParameterFile saved;
    saved.values.push_back({index, 77});
    EXPECT_TRUE(differences(device, saved).empty()) << "for showing it has the value";
    const auto writes = toRestore(device, saved);
    ASSERT_EQ(writes.size(), 1U) << "another unit may stand there by now";
    EXPECT_EQ(writes.front().from, 77);
}

TEST(ParameterFile, SavesAllOrNothing)
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath(QStringLiteral("a.json")).toStdString();
    ASSERT_TRUE(saveFile(path, "one"));
    EXPECT_EQ(loadFile(path, 3).value_or(QByteArray()), "one");
    EXPECT_FALSE(loadFile(path, 2)) << "larger than the limit";
    EXPECT_FALSE(loadFile(folder.path().toStdString(), 100)) << "a folder";
    EXPECT_FALSE(loadFile(path + ".none", 100));
    EXPECT_FALSE(saveFile(folder.filePath(QStringLiteral("no/such/folder.json")).toStdString(), "x"));
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 1) << "nothing temporary stays";
}

} // namespace
} // namespace mb
