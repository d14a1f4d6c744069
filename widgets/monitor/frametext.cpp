// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/frametext.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "wire/canerror.h"
#include "wire/number.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace mb {
namespace {

struct FrameText {
    Q_DECLARE_TR_FUNCTIONS(FrameText)
};

QString trimmedNumber(double value)
{
    if (value == std::floor(value) && std::abs(value) < 1e15)
        return formatNumber(value, 0);
    const double size = std::abs(value);
    const int digits = size >= 10000 ? 0 : size >= 1000 ? 1 : size >= 100 ? 2 : size >= 10 ? 3 : 4;
    QString text = formatNumber(value, digits);
    if (!text.contains(QLatin1Char('.')))
        return text;
    while (text.endsWith(QLatin1Char('0')))
        text.chop(1);
    return text.endsWith(QLatin1Char('.')) ? text.left(text.size() - 1) : text;
}

/// What a field is called in a line; others have their names, and flags a name of words.
constexpr std::array<std::pair<std::string_view, std::string_view>, 18> shortNames{
    {{"dtcApplied", "duty"}, {"modeSelect", "mode"}, {"errCLoop", "err"}, {"trgt", "target"}, {"pidsltSelect", "slot"},
        {"vltgRampSet", "ramp"}, {"poscnt", "pos"}, {"velcnt", "vel"}, {"vltgAnalogIn", "ain"}, {"crntOutput", "I"},
        {"tmpAmbient", "case"}, {"vltgVbus", "bus"}, {"sessid", "session"}, {"paramid", "parameter"},
        {"perc", "result"}, {"LOG", "log"}, {"TYPE", "loop"}, {"FIELD", "field"}}};

/// "fwd limit pin" of "fFwdLimitPin"; what is written in capitals stays so.
QString flagWords(std::string_view name)
{
    QString words;
    const QString letters = qt(name);
    for (int i = 1; i < letters.size(); ++i) {
        const bool isLast = i + 1 == letters.size();
        const bool begins = letters[i].isUpper() && (letters[i - 1].isLower() || (!isLast && letters[i + 1].isLower()));
        if (i > 1 && begins)
            words += QLatin1Char(' ');
        words += begins && !isLast && letters[i + 1].isLower() ? letters[i].toLower() : letters[i];
    }
    return words;
}

/// Words first, then what has a unit, then bare numbers; flags are last.
int rankOf(const DecodedField &field)
{
    return isFlag(field) ? 3 : !field.word.empty() ? 0 : !field.unit.empty() ? 1 : 2;
}

} // namespace

QString hexId(const CanFrame &frame)
{
    return QStringLiteral("%1").arg(frame.id, frame.extended || frame.error ? 8 : 3, 16, QLatin1Char('0')).toUpper();
}

QString hexBytes(std::span<const std::uint8_t> bytes)
{
    static constexpr std::string_view digits = "0123456789ABCDEF";
    QString text;
    text.reserve(static_cast<int>(bytes.size() * 3));
    for (const std::uint8_t byte : bytes) {
        if (!text.isEmpty())
            text += QLatin1Char(' ');
        text += QLatin1Char(digits[byte >> 4U]);
        text += QLatin1Char(digits[byte & 0xFU]);
    }
    return text;
}

QString hexBytes(const CanFrame &frame)
{
    return frame.remote ? FrameText::tr("remote") : hexBytes(frame.bytes());
}

QString errorFrameText(const CanFrame &frame)
{
    return messageText(describe(decodeError(frame)));
}

std::optional<double> fullScale(std::string_view unit)
{
    if (!unit.starts_with("1/"))
        return std::nullopt;
    const auto scale = numberFrom(unit.substr(2, unit.find(' ') - 2));
    return scale && *scale > 0.0 ? scale : std::nullopt;
}

QString fieldValue(const DecodedField &field)
{
    if (!field.word.empty())
        return qt(field.word);
    if (const auto scale = fullScale(field.unit)) {
        const std::size_t rest = std::min(field.unit.find(' '), field.unit.size());
        return formatValue(field.value / *scale * 100.0, 1, QStringLiteral("%") + qt(field.unit.substr(rest)));
    }
    const QString number = trimmedNumber(field.value);
    return field.unit.empty() ? number : number + QChar(QChar::Nbsp) + qt(field.unit);
}

QString wireValue(const DecodedField &field)
{
    const QString number = QString::fromStdString(numberText(field.value));
    return field.unit.empty() || fullScale(field.unit) ? number : number + QChar(QChar::Nbsp) + qt(field.unit);
}

bool isFlag(const DecodedField &field)
{
    return field.unit.empty() && field.name.size() > 1 && field.name[0] == 'f' && field.name[1] >= 'A'
        && field.name[1] <= 'Z';
}

QString fieldName(const DecodedField &field)
{
    const auto *const known
        = std::ranges::find(shortNames, field.name, &std::pair<std::string_view, std::string_view>::first);
    return known != shortNames.end() ? qt(known->second) : isFlag(field) ? flagWords(field.name) : qt(field.name);
}

QString fieldsLine(const DecodedFrame &frame)
{
    std::vector<DecodedField> fields = frame.fields;
    std::ranges::stable_sort(fields, {}, rankOf);
    QStringList parts;
    for (const DecodedField &field : fields) {
        if (!isFlag(field))
            parts += fieldName(field) + QLatin1Char('=') + fieldValue(field);
        else if (field.value != 0.0)
            parts += fieldName(field);
    }
    return parts.join(QStringLiteral("  "));
}

QString wireLine(const DecodedFrame &frame)
{
    QStringList parts;
    for (const DecodedField &field : frame.fields)
        parts += qt(field.name) + QLatin1Char('=') + wireValue(field);
    return parts.join(QStringLiteral("  "));
}

QString addressText(const DecodedFrame &frame)
{
    return frame.address < 0 ? QString(UnknownMark) : QString::number(frame.address);
}

std::optional<std::size_t> tellingField(const DecodedFrame &frame)
{
    const auto found
        = std::ranges::find_if(frame.fields, [](const DecodedField &field) { return !field.unit.empty(); });
    if (found != frame.fields.end())
        return static_cast<std::size_t>(found - frame.fields.begin());
    return frame.fields.empty() ? std::nullopt : std::optional<std::size_t>(0);
}

} // namespace mb
