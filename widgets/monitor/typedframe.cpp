// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/typedframe.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace mb {
namespace {

struct TypedFrameText {
    Q_DECLARE_TR_FUNCTIONS(TypedFrameText)
};

} // namespace

TypedFrame readTypedFrame(const QString &id, bool extended, const QString &data)
{
    QString digits = id.trimmed();
    const int hash = digits.indexOf(QLatin1Char('#'));
    if (hash >= 0) {
        const auto whole = canFrameFromText(digits.section(QLatin1Char(' '), -1).toStdString());
        return whole ? TypedFrame{whole, {}}
                     : TypedFrame{{}, TypedFrameText::tr("'%1' is no frame such as 02061405#8125").arg(digits)};
    }
    if (digits.startsWith(QLatin1String("0x"), Qt::CaseInsensitive))
        digits.remove(0, 2);
    bool good = false;
    const uint number = digits.toUInt(&good, 16);
    if (!good)
        return {{}, TypedFrameText::tr("The identifier is hexadecimal, such as 7FF or 02061405")};
    if (number > (extended ? 0x1FFFFFFFU : 0x7FFU))
        return {{},
            extended ? TypedFrameText::tr("%1 has more than 29 bits: at most 1FFFFFFF").arg(digits)
                     : TypedFrameText::tr("%1 has more than 11 bits: choose 29 bits").arg(digits)};
    QString bytes = data;
    bytes.remove(QRegularExpression(QStringLiteral("[\\s.]")));
    static const QRegularExpression hex(QStringLiteral("^([0-9A-Fa-f]{2})*$"));
    if (!hex.match(bytes).hasMatch())
        return {{}, TypedFrameText::tr("The data are pairs of hexadecimal digits, such as 81 25 11")};
    if (bytes.size() > 16)
        return {{}, TypedFrameText::tr("%1 bytes: a frame has at most 8").arg(bytes.size() / 2)};
    CanFrame frame;
    frame.id = number;
    frame.extended = extended;
    frame.size = static_cast<std::uint8_t>(bytes.size() / 2);
    for (int i = 0; i < frame.size; ++i)
        frame.data.at(static_cast<std::size_t>(i)) = static_cast<std::uint8_t>(bytes.mid(i * 2, 2).toUInt(nullptr, 16));
    return {frame, {}};
}

} // namespace mb
