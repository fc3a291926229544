// How surfaces are lit: one light from above and the left of the first view, as in the films.
import { Matrix3, Vector2, Vector3 } from "three";

/** Towards the light, world. */
export const LIGHT = new Vector3(0.5, -0.42, 0.85).normalize();

/** What all materials share: the light, how normals turn from the data's world to the drawn one, the picture's size, px. */
export const sharedUniforms = () => ({
  uLight: { value: LIGHT }, uTurn: { value: new Matrix3() }, uViewport: { value: new Vector2(1, 1) },
  uEye: { value: new Vector3() },
});

/** GLSL for vertices: halfway between the light and the eye; every lit surface hands it on with its normal. */
export const HALFWAY = /* glsl */ `
  uniform vec3 uLight, uEye;
  varying vec3 vNormal, vHalfway;
  void face(vec3 normal, vec3 at) {
    vNormal = normal;
    vHalfway = normalize(uLight + normalize(uEye - at));
  }
`;

/** GLSL for fragments: a colour, lit. Ambient, diffuse and a little shine, in the page's own colours. */
export const LIT = /* glsl */ `
  uniform vec3 uLight;
  varying vec3 vNormal, vHalfway;
  float matt(vec3 normal) {
    return 0.56 + 0.06 * normal.z + 0.46 * max(dot(normal, uLight), 0.0);
  }
  float shine(vec3 normal) {
    float s = max(dot(normal, vHalfway), 0.0);
    s *= s; s *= s; s *= s; s *= s;
    return s * s;
  }
`;
