// SPDX-License-Identifier: MIT
// A three-dimensional cam with its rollers: turned by the cam angle, looked at from anywhere.
'use strict';
(function (camopt) {
  const { element } = camopt;
  const colours = { drum: 0xb9a27a, core: 0x8f99a5, cam: 0xd9a25e };

  function meshOf(three, part) {
    const geometry = new three.BufferGeometry();
    geometry.setAttribute('position', new three.BufferAttribute(new Float32Array(part.vertices), 3));
    geometry.setIndex(part.triangles);
    // Facets keep their edges: a groove's rim is sharp.
    const flat = geometry.toNonIndexed();
    flat.computeVertexNormals();
    const material = new three.MeshStandardMaterial({ color: colours[part.name] || 0xd9a25e, roughness: 0.55, metalness: 0.15,
      flatShading: true, side: part.closed ? 0 : three.DoubleSide });
    return new three.Mesh(flat, material);
  }

  function extentOf(data) {
    let radius = 0, low = Infinity, high = -Infinity;
    for (const part of data.parts)
      for (let i = 0; i < part.vertices.length; i += 3) {
        radius = Math.max(radius, Math.hypot(part.vertices[i], part.vertices[i + 1]));
        low = Math.min(low, part.vertices[i + 2]);
        high = Math.max(high, part.vertices[i + 2]);
      }
    return { radius, low, high };
  }

  camopt.solid = function (angle) {
    const host = element('div', { class: 'solid' });
    const self = { host, show };
    let data = null, renderer = null, scene = null, camera = null, orbit = null, cam = null, rollers = [], three = null, wanted = false;

    function begin() {
      three = window.CamoptThree;
      if (!three) return false;
      try {
        renderer = new three.WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
      } catch (error) {
        return false;
      }
      const canvas = renderer.domElement;
      canvas.tabIndex = 0;
      canvas.setAttribute('role', 'img');
      canvas.setAttribute('aria-label', 'The cam in three dimensions with its rollers. Drag to rotate, wheel to zoom; arrow keys rotate it too.');
      camera = new three.PerspectiveCamera(32, 1, 0.1, 1e6);
      camera.up.set(0, 1, 0);
      orbit = new three.OrbitControls(camera, canvas);
      orbit.enablePan = false;
      orbit.addEventListener('change', draw);
      canvas.addEventListener('keydown', (event) => {
        const turn = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
        if (!turn) return;
        event.preventDefault();
        const away = camera.position.clone().sub(orbit.target), length = away.length();
        const azimuth = Math.atan2(away.x, away.z) + 0.12 * turn[0];
        const polar = Math.min(Math.max(Math.acos(away.y / length) - 0.12 * turn[1], 0.05), Math.PI - 0.05);
        camera.position.set(length * Math.sin(polar) * Math.sin(azimuth), length * Math.cos(polar), length * Math.sin(polar) * Math.cos(azimuth)).add(orbit.target);
        orbit.update();
      });
      host.replaceChildren(canvas);
      new ResizeObserver(resize).observe(host);
      return true;
    }

    function rollerMesh() {
      const { radius, length } = data.roller;
      const shape = new three.CylinderGeometry(radius, radius, length, 48);
      shape.translate(0, length / 2, 0);
      const group = new three.Group();
      group.add(new three.Mesh(shape, new three.MeshStandardMaterial({ color: 0x5f8fc6, roughness: 0.35, metalness: 0.3 })));
      const stem = new three.CylinderGeometry(0.45 * radius, 0.45 * radius, 0.8 * length, 24);
      stem.translate(0, -0.4 * length, 0);
      group.add(new three.Mesh(stem, new three.MeshStandardMaterial({ color: 0x6b7480, roughness: 0.5, metalness: 0.4 })));
      if (data.pivot) {
        const arm = new three.Mesh(new three.CylinderGeometry(0.3 * radius, 0.3 * radius, 1, 16), new three.MeshStandardMaterial({ color: 0x6b7480, roughness: 0.5, metalness: 0.4 }));
        group.userData.arm = arm;
        scene.add(arm);
      }
      return group;
    }

    function build() {
      scene = new three.Scene();
      scene.add(new three.HemisphereLight(0xffffff, 0x8a8f98, 1.5));
      const sun = new three.DirectionalLight(0xffffff, 2.2);
      scene.add(sun);
      sun.position.set(0.6, 1, 0.8);
      cam = new three.Group();
      data.parts.forEach((part) => cam.add(meshOf(three, part)));
      scene.add(cam);
      rollers = data.rollers.map((poses) => { const mesh = rollerMesh(); scene.add(mesh); return { poses, mesh }; });
      const { radius, low, high } = extentOf(data), size = Math.max(radius, 0.5 * (high - low));
      orbit.target.set(0, 0.12 * size, 0.5 * (low + high));
      camera.position.set(2.2 * size, 2.1 * size, 0.5 * (low + high) + 3.4 * size);
      camera.near = 0.02 * size;
      camera.far = 40 * size;
      orbit.minDistance = 1.2 * size;
      orbit.maxDistance = 12 * size;
      orbit.update();
      resize();
      move();
    }

    function move() {
      if (!data || !renderer) return;
      const [row, next, share] = angle.between();
      cam.rotation.z = data.rotation * angle.at * Math.PI / 180;
      const up = new three.Vector3(0, 1, 0);
      for (const { poses, mesh } of rollers) {
        const at = (i) => poses[6 * row + i] * (1 - share) + poses[6 * next + i] * share;
        const foot = new three.Vector3(at(0), at(1), at(2)), along = new three.Vector3(at(3), at(4), at(5)).normalize();
        mesh.position.copy(foot);
        mesh.quaternion.setFromUnitVectors(up, along);
        const arm = mesh.userData.arm;
        if (!arm) continue;
        const from = new three.Vector3(...data.pivot), to = foot.clone().addScaledVector(along, -0.8 * data.roller.length);
        if (Math.abs(along.y) > 0.999) from.y = to.y;
        const span = to.clone().sub(from);
        arm.scale.set(1, Math.max(span.length(), 1e-6), 1);
        arm.position.copy(from).addScaledVector(span, 0.5);
        arm.quaternion.setFromUnitVectors(up, span.clone().normalize());
      }
      host.dataset.turned = (data.rotation * angle.at).toFixed(3);
      draw();
    }

    function draw() {
      if (wanted || !renderer || !scene) return;
      wanted = true;
      requestAnimationFrame(() => { wanted = false; renderer.render(scene, camera); });
    }

    function resize() {
      if (!renderer || !host.clientWidth) return;
      const width = host.clientWidth, height = Math.round(Math.min(0.86 * width, 460));
      renderer.setPixelRatio(Math.min(camopt.screenDots(), 2));
      renderer.setSize(width, height);
      camera.aspect = width / height;
      camera.updateProjectionMatrix();
      renderer.render(scene || new three.Scene(), camera);
    }

    function show(solid) {
      data = solid;
      host.hidden = !data;
      if (!data) return;
      if (!renderer && !begin()) {
        host.replaceChildren(element('p', { class: 'note' }, 'The cam in three dimensions needs WebGL, which this browser does not offer. camopt export --stl writes the same solid.'));
        return;
      }
      build();
    }
    angle.changed.listen(move);
    return self;
  };
})(window.Camopt);
