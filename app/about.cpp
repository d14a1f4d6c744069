// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/about.h"

#include "model/family.h"
#include "model/registry.h"
#include "widgets/common/labels.h"
#include "widgets/plots/qcustomplotkeywords.h"

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSysInfo>
#include <QVBoxLayout>

namespace mb {
namespace {

struct Licence {
    const char *what;
    const char *licence;
};

/// Of everything that is in the program or linked by it.
constexpr Licence licences[] = {
    {"MotorBench", "GPL-3.0-or-later"},
    {"Qt 5 (Core, Gui, Widgets, Svg, Sql, SerialPort, SerialBus, DBus)", "LGPL-3.0"},
    {"QCustomPlot", "GPL-3.0-or-later"},
    {"FFTW", "GPL-2.0-or-later"},
    {"muParser", "BSD-2-Clause"},
    {"tl::expected", "CC0-1.0"},
    {"libgpiod", "LGPL-2.1-or-later"},
    {"SQLite", "public domain"},
};

constexpr int dialogWidth = 560;
constexpr int dialogHeight = 480;
constexpr double lineHeight = 18.0; ///< of the font that these are for

QString familyKeys()
{
    QStringList keys;
    for (const Family *family : families())
        keys << QString::fromUtf8(family->key.data(), static_cast<int>(family->key.size()));
    return keys.join(QStringLiteral(", "));
}

QString licenceText()
{
    QString text;
    for (const Licence &row : licences)
        text += QStringLiteral("%1: %2\n").arg(QLatin1String(row.what), QLatin1String(row.licence));
    return text;
}

} // namespace

QString versions()
{
    return QStringLiteral(
        "MotorBench %1\nfamilies: %2\nQt %3 (built with %4), platform %5\nQCustomPlot %6\n%7, kernel %8, %9\n")
        .arg(QApplication::applicationVersion(), familyKeys(), QLatin1String(qVersion()), QLatin1String(QT_VERSION_STR),
            QGuiApplication::platformName(), QLatin1String(QCUSTOMPLOT_VERSION_STR), QSysInfo::prettyProductName(),
            QSysInfo::kernelVersion(), QSysInfo::currentCpuArchitecture());
}

About::About(QWidget *parent)
    : QDialog(parent)
{
    setWindowTitle(tr("About MotorBench"));
    auto *column = new QVBoxLayout(this);
    const QString name = QStringLiteral("MotorBench %1").arg(QApplication::applicationVersion());
    column->addWidget(textLabel(name, TextRole::Title, Tone::Text, this));
    auto *what = textLabel(
        tr("Tunes and services brushed-DC motor controllers. Free software under the GNU General Public License, "
           "version 3 or later, without any warranty."),
        TextRole::Body, Tone::Dim, this);
    what->setWordWrap(true);
    column->addWidget(what);
    auto *text = new QPlainTextEdit(versions() + QLatin1Char('\n') + licenceText(), this);
    text->setReadOnly(true);
    text->setTabChangesFocus(true);
    text->setAccessibleName(tr("Versions and licences"));
    column->addWidget(text, 1);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    const QPushButton *copy = buttons->addButton(tr("Copy versions"), QDialogButtonBox::ActionRole);
    column->addWidget(buttons);
    connect(copy, &QPushButton::clicked, this, [] { QApplication::clipboard()->setText(versions()); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    const double scale = QFontMetricsF(font()).height() / lineHeight;
    resize(static_cast<int>(dialogWidth * scale), static_cast<int>(dialogHeight * scale));
}

} // namespace mb
