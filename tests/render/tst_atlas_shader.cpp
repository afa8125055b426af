// SPDX-License-Identifier: GPL-3.0-or-later
//
// The address function that shaders include, run on the card, against the one in core.
#include <QFile>
#include <QOpenGLShaderProgram>
#include <QTest>

#include "render/gl.h"
#include "render/texture_buffer.h"
#include "tests/core/atlas/atlas_pages.h"
#include "tests/render/offscreen.h"

using namespace trixel;
using namespace trixel::render;
using namespace trixel::test;

namespace {

constexpr int kQueries = 4096;
/// Hardware interpolates with weights of 8 bits.
constexpr double kTolerance = 1.0 / 128;

struct Query
{
    float face = 0;
    float level = 0;
    float u = 0;
    float v = 0;
};

const char* const kVertex = R"(#version 410 core
void main()
{
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
})";

const char* const kBefore = R"(#version 410 core
uniform usamplerBuffer table;
uniform sampler2D page0;
uniform sampler2D page1;
uniform samplerBuffer queries;
out vec4 answer;
vec4 fetch(int page, ivec2 pixel)
{
    return page == 0 ? texelFetch(page0, pixel, 0) : texelFetch(page1, pixel, 0);
}
vec4 interpolated(int page, vec2 place)
{
    return page == 0 ? textureLod(page0, place / vec2(textureSize(page0, 0)), 0.0)
                     : textureLod(page1, place / vec2(textureSize(page1, 0)), 0.0);
}
#define ATLAS_NUMBER(k) texelFetch(table, k).x
#define ATLAS_FETCH(page, pixel) fetch(page, pixel)
#define ATLAS_SAMPLE(page, place) interpolated(page, place)
)";

const char* const kAfter = R"(
void main()
{
    vec4 query = texelFetch(queries, int(gl_FragCoord.x));
    int face = int(query.x);
    int level = min(int(query.y), atlasLevel(face));
    answer = vec4(atlasNearest(face, level, query.zw).x,
                  atlasBilinear(face, level, query.zw).x,
                  atlasTrilinear(face, query.y, query.zw).x,
                  float(atlasLevel(face)));
})";

QByteArray fragmentSource()
{
    QFile file(":/shaders/atlas.glsl");
    return file.open(QIODevice::ReadOnly) ? kBefore + file.readAll() + kAfter : QByteArray();
}

std::vector<Query> randomQueries(std::size_t faces)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<float> in(0, 1);
    std::vector<Query> queries(kQueries);
    for (Query& query : queries) {
        query.face = static_cast<float>(random() % faces);
        query.level = 7 * in(random);
        query.u = in(random);
        query.v = in(random);
        if (query.u + query.v > 1) {
            query.u = 1 - query.u;
            query.v = 1 - query.v;
        }
    }
    return queries;
}

} // namespace

class TestAtlasShader : public QObject
{
    Q_OBJECT

private slots:
    void theCardReadsWhatCoreReads()
    {
        const TriangleMesh mesh = turnedGrid(7, 1);
        const Adjacency adjacency = buildAdjacency(mesh.triangles);
        std::mt19937 random(2);
        FaceMap<Level> levels(mesh.faceCount());
        for (std::size_t f = 0; f < levels.size(); ++f) {
            levels[faceId(f)] = Level(static_cast<int>(random() % 7));
        }
        std::uniform_real_distribution<float> in(0, 1);
        const TexelStore store = storeOf(levels, [&](FaceId, glm::dvec2) { return in(random); });
        const AtlasPages atlas(
            AtlasLayout::plan(levels, {AtlasBorder::Bilinear, AtlasPacking::Shelves, true, 320})
                .value(),
            store,
            adjacency);
        QCOMPARE(atlas.pages.size(), std::size_t{2});
        const std::vector<Query> queries = randomQueries(mesh.faceCount());
        const std::vector<glm::vec4> answers = ask(atlas, queries);
        QCOMPARE(answers.size(), queries.size());
        for (std::size_t k = 0; k < queries.size(); ++k) {
            const FaceId face = faceId(static_cast<std::size_t>(queries[k].face));
            const Level own = atlas.layout.level(face);
            const Level level = std::min(own, Level(static_cast<int>(queries[k].level)));
            const glm::dvec2 uv(queries[k].u, queries[k].v);
            QCOMPARE(answers[k].x, atlas.value(nearestTap(atlas.layout, face, level, uv)));
            const double bilinear = atlas.sum(bilinearTaps(atlas.layout, face, level, uv));
            QVERIFY(std::abs(static_cast<double>(answers[k].y) - bilinear) < kTolerance);
            const double trilinear =
                atlas.sum(trilinearTaps(atlas.layout, face, queries[k].level, uv));
            QVERIFY(std::abs(static_cast<double>(answers[k].z) - trilinear) < kTolerance);
            QCOMPARE(answers[k].w, static_cast<float>(own.log2()));
        }
    }

private:
    /// Nearest, bilinear and trilinear values and the face's level, of each query.
    static std::vector<glm::vec4> ask(const AtlasPages& atlas, const std::vector<Query>& queries)
    {
        const Offscreen context(64, 64);
        const auto gl = currentGl();
        QOpenGLShaderProgram program;
        if (!program.addShaderFromSourceCode(QOpenGLShader::Vertex, kVertex) ||
            !program.addShaderFromSourceCode(QOpenGLShader::Fragment, fragmentSource()) ||
            !program.link()) {
            return {};
        }
        TextureBuffer table(*gl, GL_R32UI, sizeof(std::uint32_t));
        const std::vector<std::uint32_t> numbers = atlasTable(atlas.layout);
        table.fill(std::as_bytes(std::span(numbers)));
        TextureBuffer asked(*gl, GL_RGBA32F, sizeof(Query));
        asked.fill(std::as_bytes(std::span(queries)));
        std::array<GLuint, 3> textures{};
        gl->glGenTextures(3, textures.data());
        const auto makeTexture = [&](GLuint unit,
                                     const AtlasPage& size,
                                     GLenum inside,
                                     GLenum outside,
                                     const float* values) {
            gl->glActiveTexture(GL_TEXTURE0 + unit);
            gl->glBindTexture(GL_TEXTURE_2D, textures[unit - 2]);
            gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
            gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
            gl->glTexImage2D(GL_TEXTURE_2D,
                             0,
                             static_cast<GLint>(inside),
                             static_cast<GLsizei>(size.width),
                             static_cast<GLsizei>(size.height),
                             0,
                             outside,
                             GL_FLOAT,
                             values);
        };
        for (GLuint page = 0; page < 2; ++page) {
            makeTexture(
                page + 2, atlas.layout.pages()[page], GL_R32F, GL_RED, atlas.pages[page].data());
        }
        makeTexture(4, {kQueries, 1}, GL_RGBA32F, GL_RGBA, nullptr);
        GLuint target = 0;
        GLuint array = 0;
        gl->glGenFramebuffers(1, &target);
        gl->glBindFramebuffer(GL_FRAMEBUFFER, target);
        gl->glFramebufferTexture2D(
            GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures[2], 0);
        gl->glGenVertexArrays(1, &array);
        gl->glBindVertexArray(array);
        gl->glViewport(0, 0, kQueries, 1);
        program.bind();
        table.bind(0);
        asked.bind(1);
        program.setUniformValue("table", 0);
        program.setUniformValue("queries", 1);
        program.setUniformValue("page0", 2);
        program.setUniformValue("page1", 3);
        gl->glDrawArrays(GL_TRIANGLES, 0, 3);
        std::vector<glm::vec4> answers(kQueries);
        gl->glReadPixels(0, 0, kQueries, 1, GL_RGBA, GL_FLOAT, answers.data());
        gl->glBindFramebuffer(GL_FRAMEBUFFER, 0);
        gl->glDeleteFramebuffers(1, &target);
        gl->glDeleteVertexArrays(1, &array);
        gl->glDeleteTextures(3, textures.data());
        return gl->glGetError() == GL_NO_ERROR ? answers : std::vector<glm::vec4>();
    }
};

QTEST_MAIN(TestAtlasShader)
#include "tst_atlas_shader.moc"
