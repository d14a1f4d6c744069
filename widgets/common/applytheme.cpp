// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/applytheme.h"

#include <QApplication>
#include <QFile>
#include <QHash>
#include <QRegularExpression>
#include <QStyleFactory>
#include <QToolTip>

namespace mb {
namespace {

QHash<QString, QColor> colourTokens(const Theme &t)
{
    return {{QStringLiteral("canvas"), t.canvas}, {QStringLiteral("window"), t.window},
        {QStringLiteral("head"), t.head}, {QStringLiteral("panel"), t.panel}, {QStringLiteral("control"), t.control},
        {QStringLiteral("hover"), t.hover}, {QStringLiteral("line"), t.line}, {QStringLiteral("grid"), t.grid},
        {QStringLiteral("outline"), t.outline}, {QStringLiteral("text"), t.text}, {QStringLiteral("dim"), t.dim},
        {QStringLiteral("faint"), t.faint}, {QStringLiteral("accent"), t.accent}, {QStringLiteral("fill"), t.fill},
        {QStringLiteral("onFill"), t.onFill}, {QStringLiteral("sel"), t.sel}, {QStringLiteral("ok"), t.ok},
        {QStringLiteral("caution"), t.caution}, {QStringLiteral("danger"), t.danger}, {QStringLiteral("stop"), t.stop},
        {QStringLiteral("armed"), t.armed}, {QStringLiteral("onArmed"), t.onArmed},
        {QStringLiteral("bannerCaution"), t.bannerCaution}, {QStringLiteral("bannerDanger"), t.bannerDanger},
        {QStringLiteral("bannerOk"), t.bannerOk}, {QStringLiteral("bannerInfo"), t.bannerInfo},
        {QStringLiteral("editedTint"), t.editedTint}, {QStringLiteral("errorTint"), t.errorTint}};
}

QString tokenValue(const QRegularExpressionMatch &match, const QHash<QString, QColor> &colours, const Theme &theme)
{
    if (match.capturedLength(1) > 0) {
        const QString name = match.captured(1);
        if (name == QLatin1String("scheme"))
            return theme.dark ? QStringLiteral("dark") : QStringLiteral("light");
        const auto found = colours.find(name);
        return found == colours.end() ? match.captured(0) : found->name();
    }
    const double number = match.captured(2).toDouble();
    if (match.captured(3) == QLatin1String("f"))
        return QString::number(number * theme.bodyPointSize, 'f', 2) + QStringLiteral("pt");
    return QString::number(theme.u(number)) + QStringLiteral("px");
}

} // namespace

QPalette themePalette(const Theme &t)
{
    QPalette p;
    const auto all = [&p](QPalette::ColorRole role, const QColor &colour) { p.setColor(role, colour); };
    all(QPalette::Window, t.window);
    all(QPalette::Base, t.canvas);
    all(QPalette::AlternateBase, t.panel);
    all(QPalette::Button, t.control);
    all(QPalette::Mid, t.line);
    all(QPalette::Dark, t.outline);
    all(QPalette::Light, t.hover);
    all(QPalette::Midlight, t.hover);
    all(QPalette::WindowText, t.text);
    all(QPalette::Text, t.text);
    all(QPalette::ButtonText, t.text);
    all(QPalette::BrightText, t.danger);
    all(QPalette::Link, t.accent);
    all(QPalette::LinkVisited, t.accent);
    all(QPalette::Highlight, t.sel);
    all(QPalette::HighlightedText, t.text);
    all(QPalette::PlaceholderText, t.faint);
    all(QPalette::ToolTipBase, t.panel);
    all(QPalette::ToolTipText, t.text);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText})
        p.setColor(QPalette::Disabled, role, t.faint);
    return p;
}

QString fillStyleSheet(const QString &sheet, const Theme &theme)
{
    static const QRegularExpression token(QStringLiteral(R"(@([A-Za-z]+)|(?<![\w.#])(-?\d+(?:\.\d+)?)([uf])\b)"));
    const auto colours = colourTokens(theme);
    QString filled;
    filled.reserve(sheet.size() + sheet.size() / 8);
    int last = 0;
    for (auto it = token.globalMatch(sheet); it.hasNext();) {
        const auto match = it.next();
        filled += sheet.midRef(last, match.capturedStart() - last);
        filled += tokenValue(match, colours, theme);
        last = match.capturedEnd();
    }
    return filled + sheet.midRef(last);
}

void applyTheme(QApplication &app, const Theme &theme)
{
    if (!app.property("mbFusion").toBool()) {
        app.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
        app.setProperty("mbFusion", true);
    }
    // Five times faster than exchanging one sheet for another, which leaves time to renew a motion lease.
    app.setStyleSheet({});
    const QPalette palette = themePalette(theme);
    app.setPalette(palette);
    QToolTip::setPalette(palette);
    QFile sheet(QStringLiteral(":/style.qss"));
    if (sheet.open(QIODevice::ReadOnly))
        app.setStyleSheet(fillStyleSheet(QString::fromUtf8(sheet.readAll()), theme));
    else
        qWarning("style.qss is not linked into this program");
}

} // namespace mb
