// The part of three.js that the page draws with.
export { Scene, PerspectiveCamera, WebGLRenderer } from "three";
