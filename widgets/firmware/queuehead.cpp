// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/queuehead.h"

#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/firmware/queuerecipe.h"

#include <QFileDialog>
#include <QHBoxLayout>

namespace mb {

QueueHead::QueueHead(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    auto *row = new QHBoxLayout(this);
    const int edge = theme.theme().u(10);
    row->setContentsMargins(theme.theme().u(16), edge, theme.theme().u(16), edge);
    row->setSpacing(theme.theme().u(16));
    m_name = addPair(tr("recipe"), *row, 2);
    setTextRole(*m_name, TextRole::Emphasis);
    m_image = addPair(tr("image"), *row, 3);
    m_parameters = addPair(tr("parameters"), *row, 2);
    m_number = addPair(tr("number rule"), *row, 1);
    auto *image = new CommandButton(m_theme, Symbol::Folder, tr("Open image…"), this);
    auto *recipe = new CommandButton(m_theme, Symbol::Open, tr("Open recipe…"), this);
    row->addWidget(m_openImage = image);
    row->addWidget(m_openRecipe = recipe);
    connect(image, &QPushButton::clicked, this, &QueueHead::askImage);
    connect(recipe, &QPushButton::clicked, this, &QueueHead::askRecipe);
}

QLabel *QueueHead::addPair(const QString &caption, QHBoxLayout &row, int stretch)
{
    auto *box = new QVBoxLayout;
    box->setSpacing(0);
    box->addWidget(textLabel(caption, TextRole::Caption, Tone::Dim, this));
    auto *value = new ElidedLabel({}, this);
    value->setAccessibleName(caption);
    value->setMinimumWidth(m_theme.theme().u(60));
    box->addWidget(value);
    row.addLayout(box, stretch);
    return value;
}

void QueueHead::show(const QueueRecipe &recipe)
{
    m_name->setText(recipe.matter() ? recipe.name() : tr("none yet"));
    m_image->setText(recipe.imageText());
    m_parameters->setText(recipe.parameterText());
    m_number->setText(recipe.numberText());
}

void QueueHead::setChoosing(bool on)
{
    m_openImage->setEnabled(on);
    m_openRecipe->setEnabled(on);
}

void QueueHead::askImage()
{
    auto *dialog
        = new QFileDialog(this, tr("Open a firmware image"), QString(), tr("Intel HEX (*.hex *.ihex);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &QueueHead::imageChosen);
    dialog->open();
}

void QueueHead::askRecipe()
{
    auto *dialog = new QFileDialog(this, tr("Open recipe"), QString(), tr("Recipes (*.json);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &QueueHead::recipeChosen);
    dialog->open();
}

} // namespace mb
