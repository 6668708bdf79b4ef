#include "ui/map/mesh_nodes.h"

#include <QSGMaterial>

#include <array>
#include <cstring>
#include <memory>

namespace furrow {

namespace {

/// The uniforms behind the matrix: the same layout in both pairs of shaders.
struct Uniforms {
    std::array<float, 4> color{};
    std::array<float, 4> first{};
    std::array<float, 4> second{};

    friend bool operator==(const Uniforms&, const Uniforms&) = default;
};

class MeshShader : public QSGMaterialShader {
public:
    MeshShader(const char* vertex, const char* fragment, std::size_t extraBytes);
    bool updateUniformData(RenderState& state, QSGMaterial* newMaterial, QSGMaterial* oldMaterial) override;

private:
    std::size_t extraBytes_;
};

class MeshMaterial : public QSGMaterial {
public:
    MeshMaterial() { setFlag(Blending | NoBatching | RequiresFullMatrix); }
    int compare(const QSGMaterial* other) const override {
        const auto* mesh = static_cast<const MeshMaterial*>(other);
        return std::memcmp(&uniforms, &mesh->uniforms, sizeof uniforms);
    }
    Uniforms uniforms;
};

class LineMaterial final : public MeshMaterial {
public:
    QSGMaterialType* type() const override {
        static QSGMaterialType type;
        return &type;
    }
    QSGMaterialShader* createShader(QSGRendererInterface::RenderMode) const override {
        return new MeshShader{"line", "line", sizeof(Uniforms)};
    }
};

class DashMaterial final : public MeshMaterial {
public:
    QSGMaterialType* type() const override {
        static QSGMaterialType type;
        return &type;
    }
    QSGMaterialShader* createShader(QSGRendererInterface::RenderMode) const override {
        return new MeshShader{"line", "dash", sizeof(Uniforms)};
    }
};

class FillMaterial final : public MeshMaterial {
public:
    QSGMaterialType* type() const override {
        static QSGMaterialType type;
        return &type;
    }
    QSGMaterialShader* createShader(QSGRendererInterface::RenderMode) const override {
        return new MeshShader{"fill", "fill", sizeof(Uniforms) - sizeof(Uniforms::second)};
    }
};

class HatchMaterial final : public MeshMaterial {
public:
    QSGMaterialType* type() const override {
        static QSGMaterialType type;
        return &type;
    }
    QSGMaterialShader* createShader(QSGRendererInterface::RenderMode) const override {
        return new MeshShader{"fill", "hatch", sizeof(Uniforms) - sizeof(Uniforms::second)};
    }
};

MeshShader::MeshShader(const char* vertex, const char* fragment, std::size_t extraBytes)
    : extraBytes_{extraBytes} {
    setShaderFileName(VertexStage,
                      QStringLiteral(":/furrow/map/shaders/%1.vert.qsb").arg(QLatin1String{vertex}));
    setShaderFileName(FragmentStage,
                      QStringLiteral(":/furrow/map/shaders/%1.frag.qsb").arg(QLatin1String{fragment}));
}

/// Gives a node another material with the same uniforms, where it has another one.
template <class Material>
void useMaterial(QSGGeometryNode& node) {
    auto* old = static_cast<MeshMaterial*>(node.material());
    if (auto wanted = std::make_unique<Material>(); old->type() != wanted->type()) {
        wanted->uniforms = old->uniforms;
        // The node owns its material and deletes the old one.
        node.setMaterial(wanted.release());
    }
}

bool MeshShader::updateUniformData(RenderState& state, QSGMaterial* newMaterial, QSGMaterial*) {
    QByteArray* data = state.uniformData();
    const QMatrix4x4 matrix = state.combinedMatrix();
    std::memcpy(data->data(), matrix.constData(), 64);
    Uniforms uniforms = static_cast<MeshMaterial*>(newMaterial)->uniforms;
    for (float& channel : uniforms.color) {
        channel *= state.opacity();
    }
    std::memcpy(data->data() + 64, &uniforms, extraBytes_);
    return true;
}

std::array<float, 4> premultiplied(const QColor& color) {
    const float alpha = color.alphaF();
    return {color.redF() * alpha, color.greenF() * alpha, color.blueF() * alpha, alpha};
}

const QSGGeometry::AttributeSet& lineAttributes() {
    static const std::array attributes{QSGGeometry::Attribute::createWithAttributeType(
                                           0, 2, QSGGeometry::FloatType, QSGGeometry::PositionAttribute),
                                       QSGGeometry::Attribute::createWithAttributeType(
                                           1, 2, QSGGeometry::FloatType, QSGGeometry::UnknownAttribute),
                                       QSGGeometry::Attribute::createWithAttributeType(
                                           2, 3, QSGGeometry::FloatType, QSGGeometry::UnknownAttribute)};
    static const QSGGeometry::AttributeSet set{static_cast<int>(attributes.size()), sizeof(LineVertex),
                                               attributes.data()};
    return set;
}

void setUniforms(QSGGeometryNode& node, const Uniforms& uniforms) {
    auto* material = static_cast<MeshMaterial*>(node.material());
    if (material->uniforms != uniforms) {
        material->uniforms = uniforms;
        node.markDirty(QSGNode::DirtyMaterial);
    }
}

Uniforms uniformsOf(const QSGGeometryNode& node) {
    return static_cast<const MeshMaterial*>(node.material())->uniforms;
}

/// A node without vertices has no place among those that are drawn, and a new geometry alone does not give it
/// one.
QSGNode::DirtyState afterChange(bool wasEmpty) {
    return wasEmpty ? QSGNode::DirtyGeometry | QSGNode::DirtyMaterial : QSGNode::DirtyGeometry;
}

}  // namespace

LineNode::LineNode() {
    auto* geometry = new QSGGeometry{lineAttributes(), 0, 0, QSGGeometry::UnsignedIntType};
    geometry->setDrawingMode(QSGGeometry::DrawTriangles);
    geometry->setVertexDataPattern(QSGGeometry::StaticPattern);
    geometry->setIndexDataPattern(QSGGeometry::StaticPattern);
    setGeometry(geometry);
    setMaterial(new LineMaterial);
    setFlags(OwnsGeometry | OwnsMaterial);
}

void LineNode::setMesh(const LineMesh& mesh) {
    const auto& vertices = mesh.vertices();
    const auto segments = static_cast<unsigned>(vertices.size() / 4);
    const bool wasEmpty = geometry()->vertexCount() == 0;
    geometry()->allocate(static_cast<int>(vertices.size()), static_cast<int>(segments * 6));
    if (segments > 0) {
        std::memcpy(geometry()->vertexData(), vertices.data(), vertices.size() * sizeof(LineVertex));
    }
    auto* index = geometry()->indexDataAsUInt();
    for (unsigned i = 0; i < segments; ++i) {
        for (const unsigned corner : {0U, 1U, 2U, 1U, 3U, 2U}) {
            *index++ = i * 4 + corner;
        }
    }
    geometry()->markVertexDataDirty();
    geometry()->markIndexDataDirty();
    markDirty(afterChange(wasEmpty));
}

void LineNode::setStyle(const LineStyle& style) {
    if (style.periodPx > 0.0) {
        useMaterial<DashMaterial>(*this);
    } else {
        useMaterial<LineMaterial>(*this);
    }
    Uniforms uniforms = uniformsOf(*this);
    uniforms.color = premultiplied(style.color);
    uniforms.first[1] = static_cast<float>(style.widthPx / 2.0);
    uniforms.second = {static_cast<float>(style.dashPx), static_cast<float>(style.periodPx), 0.0F, 0.0F};
    setUniforms(*this, uniforms);
}

void LineNode::setScale(double pixelsPerUnit, double devicePixelRatio) {
    Uniforms uniforms = uniformsOf(*this);
    uniforms.first[0] = static_cast<float>(pixelsPerUnit);
    uniforms.first[2] = static_cast<float>(devicePixelRatio);
    setUniforms(*this, uniforms);
}

void LineNode::setShown(bool shown) {
    if (shown != shown_) {
        shown_ = shown;
        markDirty(DirtySubtreeBlocked);
    }
}

FillNode::FillNode() {
    auto* geometry = new QSGGeometry{QSGGeometry::defaultAttributes_Point2D(), 0};
    geometry->setDrawingMode(QSGGeometry::DrawTriangles);
    geometry->setVertexDataPattern(QSGGeometry::StaticPattern);
    setGeometry(geometry);
    setMaterial(new FillMaterial);
    setFlags(OwnsGeometry | OwnsMaterial);
}

void FillNode::setMesh(const FillMesh& mesh) {
    static_assert(sizeof(MapPoint) == sizeof(QSGGeometry::Point2D));
    const bool wasEmpty = geometry()->vertexCount() == 0;
    geometry()->allocate(static_cast<int>(mesh.size()));
    if (!mesh.empty()) {
        std::memcpy(geometry()->vertexData(), mesh.data(), mesh.size() * sizeof(MapPoint));
    }
    geometry()->markVertexDataDirty();
    markDirty(afterChange(wasEmpty));
}

void FillNode::setStyle(const QColor& color, double hatchPx) {
    if (hatchPx > 0.0) {
        useMaterial<HatchMaterial>(*this);
    } else {
        useMaterial<FillMaterial>(*this);
    }
    Uniforms uniforms = uniformsOf(*this);
    uniforms.color = premultiplied(color);
    uniforms.first[1] = static_cast<float>(hatchPx);
    uniforms.first[2] = 1.2F;
    setUniforms(*this, uniforms);
}

void FillNode::setScale(double pixelsPerUnit, double devicePixelRatio) {
    Uniforms uniforms = uniformsOf(*this);
    uniforms.first[0] = static_cast<float>(pixelsPerUnit);
    uniforms.first[3] = static_cast<float>(devicePixelRatio);
    setUniforms(*this, uniforms);
}

void FillNode::setShown(bool shown) {
    if (shown != shown_) {
        shown_ = shown;
        markDirty(DirtySubtreeBlocked);
    }
}

}  // namespace furrow
