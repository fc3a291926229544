// The part of three.js that the page draws with.
export {
  BufferAttribute, BufferGeometry, CanvasTexture, DataTexture, DoubleSide, DynamicDrawUsage, Group, LinearFilter,
  Matrix3, Matrix4, Mesh, PerspectiveCamera, RedFormat, Scene, ShaderMaterial, UnsignedByteType, Vector2, Vector3, WebGLRenderer,
} from "three";
