// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is drawn of a footprint: laid flat, and as lines on the surface.
#include <QApplication>
#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QPalette>
#include <QSvgGenerator>
#include <QTest>

#include "core/mesh/adjacency.h"
#include "tests/ui/fixtures.h"
#include "ui/inspector/footprint_lines.h"
#include "ui/inspector/footprint_net_painter.h"
#include "ui/viewport/surface_lines.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>

namespace trixel::ui {

namespace {

const QRectF kArea(0, 0, 320, 260);

QPalette lightPalette()
{
    QPalette palette;
    palette.setColor(QPalette::Window, QColor(240, 240, 240));
    palette.setColor(QPalette::Base, Qt::white);
    palette.setColor(QPalette::AlternateBase, QColor(247, 247, 247));
    palette.setColor(QPalette::Text, Qt::black);
    return palette;
}

/// A tent of two faces over the diagonal of a square, and their neighbours: levels differ.
struct Tent
{
    TriangleMesh mesh = gridMesh(4);
    Adjacency adjacency;
    TexelStore texels;
    std::shared_ptr<const Surface> surface;

    Tent()
    {
        for (glm::vec3& position : mesh.positions) {
            position.z = 0.7F * std::abs(position.x + position.y - 1.0F);
        }
        adjacency = buildAdjacency(mesh.triangles);
        FaceMap<Level> levels(mesh.faceCount(), Level(3));
        for (std::size_t f = 0; f < levels.size(); f += 3) {
            levels[faceId(f)] = Level(2);
        }
        const std::array<std::byte, 3> fill{std::byte{200}, std::byte{120}, std::byte{40}};
        texels = TexelStore(TexelFormat{}, levels, fill);
        NoProgress progress;
        surface = Surface::build(mesh, progress).value();
    }

    SeenSurface seen() const { return SeenSurface(*surface); }

    FootprintNet net(const PlacedFootprint& footprint) const
    {
        return footprintNet(mesh, adjacency, texels, footprint);
    }
};

const PlacedFootprint kFootprint{faceId(12), {0.4, 0.45}, {{0.9, 0.25}, {-0.15, 0.4}}};

/// The weights that a Gaussian gives: none of a method, so that the picture changes with nothing
/// but how it is drawn.
Contributions gaussianWeights(const FootprintNet& net)
{
    Contributions weights;
    const glm::dvec2 major = net.widenedMajor / glm::dot(net.widenedMajor, net.widenedMajor);
    const glm::dvec2 minor = net.widenedMinor / glm::dot(net.widenedMinor, net.widenedMinor);
    for (const FootprintNet::Face& face : net.faces) {
        for (std::uint32_t t = 0; t < face.level.texelCount(); ++t) {
            const TexelCoord texel = texelAt(face.level, static_cast<TexelIndex>(t));
            const glm::dvec2 at = face.pointOf(centroid(face.level, texel));
            const double x = glm::dot(major, at);
            const double y = glm::dot(minor, at);
            weights.texels.push_back(
                {face.face, face.level, texel, std::exp(-(x * x + y * y) / 2) / 40});
        }
    }
    std::ranges::sort(weights.texels, std::ranges::greater(), &Contribution::weight);
    return weights;
}

NetPicture pictureOf(const Tent& tent)
{
    NetPicture picture;
    picture.net = tent.net(kFootprint);
    picture.weights = gaussianWeights(picture.net);
    picture.texels = tent.texels;
    return picture;
}

QImage drawn(const NetPicture& picture, const QPalette& palette = lightPalette())
{
    QImage image(kArea.size().toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    paintNet(painter, kArea, picture, fittedView(picture.net, kArea), palette);
    return image;
}

/// Share of pixels that differ by more than antialiasing and fonts do.
double difference(const QImage& a, const QImage& b)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y);
            const QColor q = b.pixelColor(x, y);
            count += std::abs(p.red() - q.red()) > 60 || std::abs(p.green() - q.green()) > 60 ||
                     std::abs(p.blue() - q.blue()) > 60;
        }
    }
    return double(count) / (a.width() * a.height());
}

bool isAlike(const QColor& a, const QColor& b)
{
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
               std::abs(a.blue() - b.blue()) <
           60;
}

/// Whether a pixel about the place has the colour: lines are antialiased.
bool isThere(const QImage& image, QPointF at, const QColor& color)
{
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            const QPoint pixel = at.toPoint() + QPoint(x, y);
            if (image.rect().contains(pixel) && isAlike(image.pixelColor(pixel), color)) {
                return true;
            }
        }
    }
    return false;
}

QColor colorOf(glm::vec4 color)
{
    return QColor::fromRgbF(color.r, color.g, color.b);
}

double lengthOf(const std::vector<render::Polyline>& lines)
{
    double length = 0;
    for (const render::Polyline& line : lines) {
        for (std::size_t k = 0; k + 1 < line.points.size(); ++k) {
            length += static_cast<double>(glm::distance(line.points[k], line.points[k + 1]));
        }
    }
    return length;
}

} // namespace

class FootprintPictureTest : public QObject
{
    Q_OBJECT

private slots:
    void pictureOfTheEllipseIsAsItWas()
    {
        const QImage image = drawn(pictureOf(Tent{}));
        const QString path = QStringLiteral(TRIXEL_TEST_DATA "/footprint/ellipse.png");
        if (qEnvironmentVariableIsSet("TRIXEL_WRITE_GOLDEN")) {
            QVERIFY(image.save(path));
        }
        QImage golden;
        QVERIFY2(golden.load(path), qPrintable(path));
        QCOMPARE(image.size(), golden.size());
        const double differs = difference(image, golden.convertToFormat(QImage::Format_RGB32));
        if (differs > 0.01) {
            image.save("ellipse-seen.png");
        }
        QVERIFY2(differs <= 0.01, qPrintable(QString::number(differs)));
        // It would notice an ellipse that is a tenth wider.
        NetPicture other = pictureOf(Tent{});
        other.net.widenedMinor *= 1.1;
        other.net.minor *= 1.1;
        QImage wider(image.size(), image.format());
        QPainter painter(&wider);
        paintNet(painter, kArea, other, fittedView(pictureOf(Tent{}).net, kArea), lightPalette());
        painter.end();
        QVERIFY(difference(wider, golden.convertToFormat(QImage::Format_RGB32)) > 0.01);
    }

    void linesLieWhereTheNumbersSay()
    {
        const NetPicture picture = pictureOf(Tent{});
        const FootprintNet& net = picture.net;
        const QImage image = drawn(picture);
        const NetView view = fittedView(net, kArea);
        int seen = 0;
        for (int k = 0; k < 32; ++k) {
            const double angle = 2 * std::numbers::pi * (k + 0.5) / 32;
            const QPointF at = view.toPicture(std::cos(angle) * net.widenedMajor +
                                              std::sin(angle) * net.widenedMinor);
            seen += isThere(image, at, colorOf(kEllipseColor));
        }
        QVERIFY(seen >= 26); // handles and the parallelogram are drawn over it
        seen = 0;
        for (int k = 0; k < 16; ++k) {
            const double t = (k + 0.5) / 16 - 0.5;
            const QPointF at = view.toPicture(net.w1 / 2.0 + t * net.w2);
            seen += isThere(image, at, colorOf(kParallelogramColor));
        }
        QVERIFY(seen >= 8);
    }

    void heaviestTexelHasTheLightestColour()
    {
        double before = -1;
        for (double share = 0; share <= 1; share += 0.125) {
            const double lightness = weightColor(share).lightnessF();
            QVERIFY(share < 0.1 || lightness > before);
            before = lightness;
        }
    }

    void frozenFootprintIsDrawnBesideTheLiveOne()
    {
        NetPicture picture = pictureOf(Tent{});
        const QImage without = drawn(picture);
        picture.frozen = PlacedFootprint{faceId(12), {0.3, 0.3}, {{0.4, 0}, {0, 0.6}}};
        const QImage with = drawn(picture);
        QVERIFY(difference(without, with) > 0.005);
        // On a face that is not in the net there is nowhere to draw it.
        picture.frozen->face = faceId(31);
        QVERIFY(!picture.net.indexOfFace(faceId(31)));
        QCOMPARE(difference(without, drawn(picture)), 0.0);
    }

    void valuesAreThoseOfTheTexels()
    {
        NetPicture picture = pictureOf(Tent{});
        picture.fill = NetPicture::Fill::Values;
        const QImage image = drawn(picture);
        const NetView view = fittedView(picture.net, kArea);
        const auto& face = picture.net.faces.front();
        int seen = 0;
        for (std::uint32_t t = 0; t < face.level.texelCount(); ++t) {
            const glm::dvec2 uv =
                centroid(face.level, texelAt(face.level, static_cast<TexelIndex>(t)));
            const QPoint at = view.toPicture(face.pointOf(uv)).toPoint();
            if (image.rect().contains(at)) {
                seen += isAlike(image.pixelColor(at), QColor(200, 120, 40));
            }
        }
        QVERIFY(seen > 10);
    }

    void pictureIsMadeOfVectors()
    {
        const NetPicture picture = pictureOf(Tent{});
        QByteArray bytes;
        QBuffer buffer(&bytes);
        QSvgGenerator svg;
        svg.setOutputDevice(&buffer);
        svg.setSize(kArea.size().toSize());
        QPainter painter(&svg);
        paintNet(painter, kArea, picture, fittedView(picture.net, kArea), lightPalette());
        painter.end();
        QVERIFY(bytes.contains("<path") || bytes.contains("<polyline"));
        QVERIFY(!bytes.contains("<image"));
    }

    void linesFollowTheSurfaceAcrossFaces()
    {
        const Tent tent;
        const FootprintNet net = tent.net(kFootprint);
        const auto lines = footprintOnSurface(net, tent.seen(), FootprintRole::Live, true);
        QVERIFY(!lines.empty());
        std::set<bool> sides;
        for (const render::Polyline& line : lines) {
            for (const glm::vec3& point : line.points) {
                // Every point is on the tent: z follows from x and y.
                QVERIFY(std::abs(point.z - 0.7F * std::abs(point.x + point.y - 1.0F)) < 1e-4F);
                sides.insert(point.x + point.y > 1.0F);
            }
        }
        QCOMPARE(sides.size(), std::size_t{2});
    }

    void linesKeepTheirLengthsOnTheSurface()
    {
        const Tent tent;
        const FootprintNet net = tent.net({faceId(12), {0.4, 0.45}, {{0.2, 0}, {0, 0.2}}});
        const std::vector<glm::dvec2> line{{-0.1, -0.04}, {0.12, 0.03}};
        const auto pieces = onSurface(net, tent.seen(), line, {1, 1, 1, 1}, 1);
        QVERIFY(std::abs(lengthOf(pieces) - glm::distance(line[0], line[1])) < 1e-5);
    }

    void weightsOnTheSurfaceAreTheHeaviest()
    {
        const Tent tent;
        const Contributions weights = gaussianWeights(tent.net(kFootprint));
        const auto lines = weightsOnSurface(tent.seen(), weights, 20);
        QCOMPARE(lines.size(), std::size_t{20});
        QVERIFY(lines.back().width > lines.front().width); // the heaviest is drawn last
    }
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::FootprintPictureTest)
#include "tst_footprint_picture.moc"
