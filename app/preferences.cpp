// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preferences.h"

#include "app/folders/userfolders.h"
#include "app/guardian/client/guardianprocess.h"
#include "app/guardiancheck.h"
#include "app/keyspanel.h"
#include "app/languages.h"
#include "widgets/common/labels.h"
#include "widgets/common/systemtheme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QUrl>
#include <QVBoxLayout>

#include <set>

namespace mb {
namespace {

constexpr int letters = 90; ///< letters, so that a command and its key stand in one line

void choose(QComboBox &box, const QVariant &data)
{
    const int at = box.findData(data);
    box.setCurrentIndex(at < 0 ? 0 : at);
}

} // namespace

Preferences::Preferences(const Look &look, const KeyBook &keys, QWidget *parent)
    : QDialog(parent)
    , m_keys(new KeysPanel(keys, this))
{
    setObjectName(QStringLiteral("preferences"));
    setWindowTitle(tr("Preferences"));
    auto *column = new QVBoxLayout(this);
    auto *tabs = new QTabWidget(this);
    tabs->setAccessibleName(tr("Preferences"));
    tabs->addTab(makeLook(look), tr("General"));
    tabs->addTab(m_keys, tr("Keys"));
    column->addWidget(tabs, 1);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
    const QSize room = parent->window()->size();
    resize(sizeHint().expandedTo({fontMetrics().averageCharWidth() * letters, 0}).boundedTo(room * 9 / 10));
}

QWidget *Preferences::makeLook(const Look &look)
{
    auto *page = new QWidget(this);
    auto *form = new QFormLayout(page);
    m_theme = new QComboBox(this);
    m_theme->addItem(tr("dark"), QStringLiteral("dark"));
    m_theme->addItem(tr("light"), QStringLiteral("light"));
    m_theme->addItem(tr("high contrast"), QStringLiteral("contrast"));
    m_theme->addItem(tr("as the desktop"), systemThemeName());
    choose(*m_theme, look.theme);
    m_language = new QComboBox(this);
    m_language->addItem(tr("as the desktop"), QString());
    for (const auto &[code, name] : languages())
        m_language->addItem(name, code);
    choose(*m_language, look.language);
    m_size = new QComboBox(this);
    const int worn = qRound(look.fontScale * 100.0);
    for (const int size : std::set{100, 125, 150, 175, 200, worn}) // % of the desktop's text
        m_size->addItem(tr("%1 %").arg(size), size);
    choose(*m_size, worn);
    m_units = new QComboBox(this);
    m_units->addItem(tr("counts"), false);
    m_units->addItem(tr("rpm and degrees"), true);
    choose(*m_units, look.revolutions);
    m_sounds = new QCheckBox(tr("With every verdict in production"), this);
    m_sounds->setChecked(look.sounds);
    m_motion = new QCheckBox(tr("Nothing moves but data"), this);
    m_motion->setChecked(look.reducedMotion);
    const auto add = [form](const QString &name, QWidget *field) {
        field->setAccessibleName(name);
        form->addRow(name, field);
    };
    add(tr("Theme"), m_theme);
    add(tr("Language"), m_language);
    add(tr("Text size"), m_size);
    add(tr("Units"), m_units);
    add(tr("Motion"), m_motion);
    add(tr("Sounds"), m_sounds);
    add(tr("Guardian"), new GuardianCheck(QString::fromStdString(guardianBesideThisProgram()), this));
    addFolders(*form);
    return page;
}

void Preferences::addFolders(QFormLayout &form)
{
    const std::pair<QString, QString> folders[] = {
        {tr("Notebook, recordings"), QString::fromStdString(programFolder())},
        {tr("Settings, layouts"), QString::fromStdString(settingsFolder())},
    };
    for (const auto &[name, folder] : folders) {
        auto *row = new QHBoxLayout;
        auto *where = new QLabel(QDir::toNativeSeparators(folder), this);
        where->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        where->setAccessibleName(name);
        auto *open = new QPushButton(tr("Open"), this);
        open->setAccessibleName(tr("Open the folder: %1").arg(name));
        open->setAutoDefault(false);
        connect(open, &QPushButton::clicked, this, [folder = folder] {
            QDir().mkpath(folder);
            QDesktopServices::openUrl(QUrl::fromLocalFile(folder));
        });
        row->addWidget(where, 1);
        row->addWidget(open);
        form.addRow(name, row);
    }
}

KeyChoices Preferences::keys() const
{
    return m_keys->book().choices();
}

Look Preferences::look() const
{
    return {m_theme->currentData().toString(), m_language->currentData().toString(),
        m_size->currentData().toInt() / 100.0, m_motion->isChecked(), m_units->currentData().toBool(),
        m_sounds->isChecked()};
}

} // namespace mb
