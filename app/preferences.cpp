// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preferences.h"

#include "app/languages.h"
#include "widgets/common/labels.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStandardPaths>
#include <QUrl>
#include <QVBoxLayout>

namespace mb {
namespace {

constexpr int sizes[] = {100, 125, 150, 175, 200}; ///< % of the desktop's text

void choose(QComboBox &box, const QVariant &data)
{
    const int at = box.findData(data);
    box.setCurrentIndex(at < 0 ? 0 : at);
}

} // namespace

Preferences::Preferences(const Look &look, QWidget *parent)
    : QDialog(parent)
{
    setObjectName(QStringLiteral("preferences"));
    setWindowTitle(tr("Preferences"));
    auto *column = new QVBoxLayout(this);
    auto *form = new QFormLayout;
    m_theme = new QComboBox(this);
    m_theme->addItem(tr("dark"), QStringLiteral("dark"));
    m_theme->addItem(tr("light"), QStringLiteral("light"));
    choose(*m_theme, look.theme);
    m_language = new QComboBox(this);
    m_language->addItem(tr("as the desktop"), QString());
    for (const auto &[code, name] : languages())
        m_language->addItem(name, code);
    choose(*m_language, look.language);
    m_size = new QComboBox(this);
    for (const int size : sizes)
        m_size->addItem(tr("%1 %").arg(size), size);
    choose(*m_size, qRound(look.fontScale * 100.0));
    m_motion = new QCheckBox(tr("Nothing moves but data"), this);
    m_motion->setChecked(look.reducedMotion);
    const auto add = [form](const QString &name, QWidget *field) {
        field->setAccessibleName(name);
        form->addRow(name, field);
    };
    add(tr("Theme"), m_theme);
    add(tr("Language"), m_language);
    add(tr("Text size"), m_size);
    add(tr("Motion"), m_motion);
    addFolders(*form);
    column->addLayout(form);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
}

void Preferences::addFolders(QFormLayout &form)
{
    const std::pair<QString, QString> folders[] = {
        {tr("Notebook, recordings"), QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation)},
        {tr("Settings, layouts"), QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation)},
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

Look Preferences::look() const
{
    return {m_theme->currentData().toString(), m_language->currentData().toString(),
        m_size->currentData().toInt() / 100.0, m_motion->isChecked()};
}

} // namespace mb
