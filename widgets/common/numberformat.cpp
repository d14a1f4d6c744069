// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/numberformat.h"

#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

namespace mb {
namespace {

QString grouped(const QString &plain)
{
    QString text = plain;
    const int start = text.startsWith(QLatin1Char('-')) ? 1 : 0;
    int end = text.indexOf(QLatin1Char('.'));
    if (end < 0)
        end = text.size();
    else
        text[end] = decimalSign();
    for (int i = end - 3; i > start; i -= 3)
        text.insert(i, ThinSpace);
    if (start == 1)
        text[0] = MinusSign;
    return text;
}

bool isZero(const QString &plain)
{
    return std::ranges::none_of(plain, [](QChar c) { return c >= QLatin1Char('1') && c <= QLatin1Char('9'); });
}

/// Fixed notation without "-0.00".
QString fixed(double value, int decimals)
{
    QString text = QString::number(value, 'f', decimals);
    if (text.startsWith(QLatin1Char('-')) && isZero(text))
        text.remove(0, 1);
    return text;
}

} // namespace

QChar decimalSign()
{
    return QLocale().decimalPoint() == QLatin1Char(',') ? QLatin1Char(',') : QLatin1Char('.'); // digits are Latin, too
}

QChar foreignSign()
{
    return decimalSign() == QLatin1Char(',') ? QLatin1Char('.') : QLatin1Char(',');
}

QString localNumber(QString plain)
{
    return plain.replace(QLatin1Char('.'), decimalSign());
}

QString formatNumber(double value, int decimals)
{
    return std::isfinite(value) ? grouped(fixed(value, decimals)) : QString(UnknownMark);
}

QString formatCount(qint64 value)
{
    return grouped(QString::number(value));
}

QString formatWritten(const QString &plain)
{
    const bool isShort = plain.contains(QLatin1Char('e'));
    return isShort ? localNumber(plain).replace(QLatin1Char('-'), MinusSign) : grouped(plain);
}

QString formatSignificant(double value, int digits)
{
    if (!std::isfinite(value))
        return UnknownMark;
    const double size = std::abs(value);
    if (size > 0 && (size < 1e-4 || size >= 1e9))
        return localNumber(QString::number(value, 'e', digits - 1)).replace(QLatin1Char('-'), MinusSign);
    const int before = size > 0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1;
    return formatNumber(value, std::max(0, digits - before));
}

QString formatValue(double value, int decimals, const QString &unit)
{
    if (!std::isfinite(value))
        return UnknownMark;
    return unit.isEmpty() ? formatNumber(value, decimals) : formatNumber(value, decimals) + QChar(QChar::Nbsp) + unit;
}

QString formatDifference(double value, int decimals)
{
    const QString text = formatNumber(value, decimals);
    return std::isfinite(value) && value > 0 && !isZero(text) ? QLatin1Char('+') + text : text;
}

QString formatDuration(double seconds)
{
    if (!std::isfinite(seconds))
        return UnknownMark;
    const QChar space(QChar::Nbsp);
    if (std::abs(seconds) < 0.9995)
        return formatNumber(seconds * 1000, 0) + space + QStringLiteral("ms");
    if (std::abs(seconds) < 59.95)
        return formatNumber(seconds, 1) + space + QStringLiteral("s");
    const QString sign = seconds < 0 ? QString(MinusSign) : QString();
    return sign + formatClock(std::llround(std::abs(seconds)));
}

QString formatClock(qint64 seconds)
{
    const auto two = [](qint64 n) { return QStringLiteral("%1").arg(n, 2, 10, QLatin1Char('0')); };
    if (seconds < 3600)
        return QString::number(seconds / 60) + QLatin1Char(':') + two(seconds % 60);
    return QString::number(seconds / 3600) + QLatin1Char(':') + two(seconds / 60 % 60) + QLatin1Char(':')
        + two(seconds % 60);
}

QString formatBytes(qint64 bytes)
{
    const QChar space(QChar::Nbsp);
    const double size = static_cast<double>(bytes);
    if (bytes < 1000)
        return QString::number(bytes) + space + QStringLiteral("B");
    if (bytes < 999'500)
        return formatNumber(size / 1e3, 0) + space + QStringLiteral("kB");
    return bytes < 999'500'000 ? formatNumber(size / 1e6, size < 10e6 ? 1 : 0) + space + QStringLiteral("MB")
                               : formatNumber(size / 1e9, 1) + space + QStringLiteral("GB");
}

QString editText(double value)
{
    return std::isfinite(value) ? localNumber(QString::number(value, 'g', QLocale::FloatingPointShortest)) : QString();
}

QString editText(double value, int decimals)
{
    return std::isfinite(value) ? localNumber(fixed(value, decimals)) : QString();
}

std::optional<double> parseNumber(const QString &text, std::optional<double> fullScale)
{
    static const QRegularExpression shape(
        QStringLiteral(R"(^([+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][+-]?\d+)?)\s*(%?)$)"));
    QString plain = text.trimmed();
    plain.replace(MinusSign, QLatin1Char('-'));
    const auto match = shape.match(plain);
    if (!match.hasMatch())
        return {};
    const bool percent = match.capturedLength(2) > 0;
    if (percent && !fullScale)
        return {};
    bool ok = false;
    const double number = match.captured(1).replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&ok);
    if (!ok || !std::isfinite(number))
        return {};
    return percent ? number / 100.0 * *fullScale : number;
}

QString asWritten(const QString &typed)
{
    return parseNumber(typed, 1.0) ? localNumber(QString(typed).replace(QLatin1Char(','), QLatin1Char('.'))) : typed;
}

QString understoodText(const QString &typed)
{
    static const QRegularExpression notation(QStringLiteral("[eExX]"));
    const auto percent = parseNumber(typed, 100.0);
    const auto whole = percent ? std::nullopt : parseInteger(typed);
    if ((!typed.contains(notation) && !typed.contains(foreignSign())) || (!percent && !whole))
        return {};
    const QString unit = typed.contains(QLatin1Char('%')) ? QStringLiteral(" %") : QString();
    return QStringLiteral("= ") + editText(percent.value_or(static_cast<double>(whole.value_or(0)))) + unit;
}

std::optional<qint64> parseInteger(const QString &text)
{
    QString plain = text.trimmed();
    plain.replace(MinusSign, QLatin1Char('-'));
    static const QRegularExpression shape(QStringLiteral(R"(^([+-]?)(0[xX][0-9A-Fa-f]+|\d+)$)"));
    const auto match = shape.match(plain);
    if (!match.hasMatch())
        return {};
    const bool hex = match.captured(2).startsWith(QLatin1String("0x"), Qt::CaseInsensitive);
    bool ok = false;
    const qint64 number = (match.captured(1) + match.captured(2).mid(hex ? 2 : 0)).toLongLong(&ok, hex ? 16 : 10);
    return ok ? std::optional(number) : std::nullopt;
}

} // namespace mb
