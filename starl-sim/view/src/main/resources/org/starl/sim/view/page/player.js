'use strict';
(async () => {
  const $ = id => document.getElementById(id);
  const source = $('run').dataset.source; // of a run that goes on

  async function unpacked() {
    const packed = Uint8Array.from(atob($('run').textContent), c => c.charCodeAt(0));
    const plain = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
    return JSON.parse(await new Response(plain).text());
  }

  /** The first part; the others go to `grow`. A second first part replaces all: the page begins again. */
  function listened() {
    return new Promise(begin => {
      const events = new EventSource(source);
      let hasBegun = false;
      events.onopen = () => lacks(leftOut);
      events.onerror = () => lacks(events.readyState === EventSource.CLOSED
        ? 'The server no longer has this run. This page shows what it received before' : 'No connection to the server. The run may still continue');
      events.addEventListener('begin', event => {
        if (hasBegun) location.reload();
        hasBegun = true;
        begin(JSON.parse(event.data));
      });
      events.addEventListener('more', event => grow(JSON.parse(event.data)));
      events.addEventListener('end', () => events.close());
    });
  }

  /** Tells what the page of a run that goes on does not show. */
  function lacks(text) {
    $('lacks').textContent = text;
  }

  let leftOut = '';
  if (source) $('message').textContent = 'Waiting for the run to begin';
  const run = await (source ? listened() : unpacked());
  leftOut = run.leftOut || '';
  lacks(leftOut);

  const [LINE, POLYGON, ELLIPSE, TEXT, IMAGE, PATH, IF_SELECTED] = [0, 1, 2, 3, 4, 5, 6];
  const FIRST = [2, 2, 4, 4, 5]; // of the coordinates in an item of each kind
  const BODIES = run.sections.length, STATES = BODIES + 1;
  const KEPT_EVERY = 64;
  const MANY = 9; // robots from which one is searched for
  const SPEEDS = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50];
  const PARTS = { App: ['FLOOR', 'OVER'], Obstacles: ['OBSTACLES'], Trails: ['TRAILS'], Robots: ['ROBOTS', 'SELECTION'],
    Names: ['LABELS'], Bumps: ['BUMPS'], Beliefs: ['BELIEFS'], 'What went wrong': ['FAILURE'], Messages: ['MESSAGES'] };
  const SIGNS = { VIOLATION: '\u2691', CRASH: '\u2715', RESTART: '\u25cb', FAULT: '\u2223', DIFFERENCE: '\u2260', INTERVENTION: '\u25c6' };

  // ---- pictures: each is the one before, changed

  let last = run.frames.length - 1;
  const kept = [run.frames[0].map(() => [])]; // pictures to decode from
  let decoded = { number: -1, lists: kept[0] };

  function changed(list, changes) {
    if (changes.length === 0) return list;
    const items = [];
    for (const change of changes) {
      if (typeof change === 'number') {
        const from = items.length;
        for (let i = from; i < from + change; i++) items.push(list[i]);
      } else if (change[0] < 0) {
        const item = items[items.length - 1].slice();
        item[1] = change[1];
        for (let i = FIRST[item[0]]; i < item.length; i += 2) {
          item[i] += change[2];
          item[i + 1] += change[3];
        }
        items.push(item);
      } else {
        const old = list[items.length] || [];
        items.push([...old.slice(0, change[0]), ...change.slice(2), ...old.slice(old.length - change[1])]);
      }
    }
    return items;
  }

  function picture(number) {
    if (number < decoded.number || number - decoded.number > KEPT_EVERY) {
      const near = Math.min(kept.length - 1, Math.floor(number / KEPT_EVERY));
      if (number < decoded.number || near * KEPT_EVERY - 1 > decoded.number) {
        decoded = { number: near * KEPT_EVERY - 1, lists: kept[near] };
      }
    }
    while (decoded.number < number) {
      const next = decoded.number + 1;
      decoded = { number: next, lists: decoded.lists.map((list, i) => changed(list, run.frames[next][i])) };
      if ((next + 1) % KEPT_EVERY === 0) kept[(next + 1) / KEPT_EVERY] = decoded.lists;
    }
    return decoded.lists;
  }

  // ---- the canvas

  const canvas = $('floor');
  let pen = canvas.getContext('2d');
  const images = new Map();
  const hidden = new Set();
  let isDark = matchMedia('(prefers-color-scheme: dark)').matches;
  let view = null; // null shows the whole floor
  let selected = -1;

  function fitted() {
    const [left, top, right, bottom] = run.box || [0, 0, run.width, run.height];
    const scale = Math.min(canvas.clientWidth / (right - left), canvas.clientHeight / (bottom - top));
    return { scale, x: (canvas.clientWidth - scale * (left + right)) / 2, y: (canvas.clientHeight - scale * (top + bottom)) / 2 };
  }

  function use(style) {
    const [light, dark, how] = run.styles[style];
    pen.fillStyle = pen.strokeStyle = isDark ? dark : light;
    return how;
  }

  function stroke(how) {
    const [width, cap, join, ...dashes] = how.split(' ').map(Number);
    pen.lineWidth = width / 10;
    pen.lineCap = ['butt', 'round', 'square'][cap];
    pen.lineJoin = ['miter', 'round', 'bevel'][join];
    pen.setLineDash(dashes.map(dash => dash / 10));
    pen.stroke();
  }

  function trace(kind, n) {
    pen.beginPath();
    if (kind === ELLIPSE) {
      pen.ellipse(n[4] / 10, n[5] / 10, n[2] / 10, n[3] / 10, 0, 0, 2 * Math.PI);
    } else if (kind === PATH) {
      for (let i = 2; i < n.length;) {
        const [a, b, c, d, e, f] = n.slice(i + 1, i + 7).map(v => v / 10);
        switch (n[i]) {
          case 0: pen.moveTo(a, b); i += 3; break;
          case 1: pen.lineTo(a, b); i += 3; break;
          case 2: pen.quadraticCurveTo(a, b, c, d); i += 5; break;
          case 3: pen.bezierCurveTo(a, b, c, d, e, f); i += 7; break;
          default: pen.closePath(); i += 1;
        }
      }
    } else {
      for (let i = 2; i < n.length; i += 2) pen.lineTo(n[i] / 10, n[i + 1] / 10);
      if (kind === POLYGON) pen.closePath();
    }
  }

  /** As wide as in the window, whose font may be another. */
  function write(n, how) {
    const end = how.lastIndexOf(' ');
    pen.font = how.slice(0, end);
    pen.save();
    pen.translate(n[4] / 10, n[5] / 10);
    pen.rotate(Number(how.slice(end)));
    const stretch = n[3] / 10 / Math.max(1, pen.measureText(run.texts[n[2]]).width);
    pen.scale(stretch, stretch);
    pen.fillText(run.texts[n[2]], 0, 0);
    pen.restore();
  }

  function image(text) {
    if (!images.has(text)) {
      const loading = new Image();
      loading.onload = () => show();
      loading.src = run.texts[text];
      images.set(text, loading);
    }
    return images.get(text);
  }

  function draw(n) {
    if (n[0] === IMAGE) {
      pen.drawImage(image(n[2]), n[5] / 10, n[6] / 10, n[3] / 10, n[4] / 10);
      return;
    }
    const how = use(n[1]);
    if (n[0] === TEXT) {
      write(n, how);
    } else {
      trace(n[0], n);
      if (how) stroke(how); else pen.fill();
    }
  }

  /** An item on its way to the next picture's, if both are the same thing. */
  function between(a, b, share) {
    if (a === b || share === 0 || a.length !== b.length || a[0] >= PATH) return a;
    for (let i = 0; i < FIRST[a[0]]; i++) if (a[i] !== b[i]) return a;
    return a.map((v, i) => i < FIRST[a[0]] ? v : v + share * (b[i] - v));
  }

  function drawAll(items, next, share) {
    const isAlike = items.length === next.length;
    for (let i = 0; i < items.length; i++) {
      if (items[i][0] === IF_SELECTED) {
        if (items[i][1] !== selected) i += items[i][2];
      } else {
        draw(isAlike ? between(items[i], next[i], share) : items[i]);
      }
    }
  }

  // ---- lanes: painted once; only the line of the moment moves

  const strip = $('lanes').querySelector('canvas');
  const tops = new Map(); // of each robot's lanes, in units of the painter
  const inLanes = ms => run.lanes.from + (run.lanes.to - run.lanes.from) * (ms - run.fromMs) / Math.max(1, run.toMs - run.fromMs);
  const laneScale = () => strip.parentElement.clientWidth / run.lanes.width;

  function drawLanes() {
    $('lanes').hidden = !run.lanes;
    if (!run.lanes) return; // of a run that goes on
    const scale = laneScale(), dpr = window.devicePixelRatio || 1;
    const height = run.lanes.robots.reduce((sum, robot) => sum + robot[1], 0);
    strip.width = Math.round(dpr * scale * run.lanes.width);
    strip.height = Math.round(dpr * scale * height);
    strip.style.width = scale * run.lanes.width + 'px';
    strip.style.height = scale * height + 'px';
    const floor = pen;
    pen = strip.getContext('2d');
    let top = 0;
    for (const [robot, blockHeight, items] of run.lanes.robots) {
      tops.set(robot, top);
      pen.setTransform(dpr * scale, 0, 0, dpr * scale, 0, dpr * scale * top);
      items.forEach(draw);
      top += blockHeight;
    }
    pen = floor;
    if (run.failure) {
      $('then').style.left = scale * inLanes(run.failure.ms) + 'px';
      $('then').hidden = false;
    }
    $('now').style.left = scale * inLanes(nowMs) + 'px';
  }

  function showLanes() {
    if (tops.has(selected)) $('lanes').scrollTop = laneScale() * tops.get(selected);
  }

  strip.onclick = event => {
    if (!run.lanes) return;
    const share = (event.offsetX / laneScale() - run.lanes.from) / (run.lanes.to - run.lanes.from);
    pause();
    seek(run.fromMs + Math.max(0, Math.min(1, share)) * (run.toMs - run.fromMs));
    link();
  };

  // ---- time

  const FAR_MS = 1500; // behind a run that is followed
  let nowMs = run.fromMs, speed = 1, isPlaying = false, isFollowing = false, realMs = 0;
  const msOf = number => Math.min(run.toMs, run.fromMs + number * run.everyMs);

  function numberAt(ms) {
    if (ms >= run.toMs) return last;
    const number = Math.min(last, Math.floor((ms - run.fromMs) / run.everyMs + 1e-6));
    // What went wrong between two pictures is in the second one: from then on, it is shown.
    const failMs = run.failure ? run.failure.ms - 1e-6 : Infinity;
    return ms >= failMs && msOf(number) < failMs ? Math.min(last, number + 1) : number;
  }

  function show() {
    const number = numberAt(nowMs), next = Math.min(last, number + 1);
    const span = msOf(next) - msOf(number);
    const share = span > 0 ? Math.max(0, Math.min(1, (nowMs - msOf(number)) / span)) : 0;
    const now = picture(number), then = share > 0 ? picture(next) : now;
    const dpr = window.devicePixelRatio || 1;
    canvas.width = Math.round(canvas.clientWidth * dpr);
    canvas.height = Math.round(canvas.clientHeight * dpr);
    pen.fillStyle = run.paper[isDark ? 1 : 0];
    pen.fillRect(0, 0, canvas.width, canvas.height);
    const { scale, x, y } = view || fitted();
    pen.setTransform(dpr * scale, 0, 0, dpr * scale, dpr * x, dpr * y);
    run.sections.forEach((section, i) => {
      if (!hidden.has(section)) drawAll(now[i], then[i], share);
    });
    describe(now);
  }

  /** Shows a moment, and tells a page that has this one beside another, unless it wants this moment. */
  function seek(ms, isWanted) {
    nowMs = Math.max(run.fromMs, Math.min(run.toMs, ms));
    show();
    if (window !== parent && !isWanted) parent.postMessage({ nowMs }, '*');
  }

  function step(pictures) {
    pause();
    const number = numberAt(nowMs);
    const isBetween = nowMs > msOf(number) + 1e-6;
    seek(msOf(Math.max(0, Math.min(last, number + pictures + (pictures < 0 && isBetween ? 1 : 0)))));
  }

  function tick(ms) {
    if (!isPlaying) return;
    seek(nowMs + (ms - realMs) * speed);
    realMs = ms;
    if (nowMs >= run.toMs && !isGrowing()) pause(); else requestAnimationFrame(tick);
  }

  function play() {
    if (nowMs >= run.toMs && !isGrowing()) nowMs = run.fromMs;
    isPlaying = true;
    $('play').textContent = 'Pause';
    requestAnimationFrame(ms => { realMs = ms; tick(ms); });
  }

  function pause() {
    isPlaying = isFollowing = false;
    $('play').textContent = 'Play';
  }

  // ---- messages in sequence: rows of a picture, which move up when others are hidden

  let rows = [], places = [];

  function drawSequence() {
    $('messages').hidden = !run.sequence;
    $('sequence').innerHTML = run.sequence || '';
    rows = [...$('sequence').querySelectorAll('.row')];
    places = rows.map(row => row.getAttribute('transform'));
    const list = (id, names) => $(id).append(...[...new Set(names)].filter(name => name).sort().map(name => new Option(name)));
    list('of', rows.flatMap(row => row.dataset.robots.split(' ')));
    list('on', rows.map(row => row.dataset.channel));
    const heads = $('sequence').querySelector('.heads');
    $('sequence').onscroll = () => heads?.setAttribute('transform', 'translate(0,' + $('sequence').scrollTop + ')');
    rows.forEach(row => { row.onclick = () => { pause(); seek(Number(row.dataset.ms)); link(); }; });
  }

  const shownRows = () => rows.filter(row => row.style.display !== 'none');

  function filterRows() {
    const of = $('of').value, on = $('on').value;
    for (const row of rows) {
      const isShown = (!of || row.dataset.robots.split(' ').includes(of)) && (!on || row.dataset.channel === on);
      row.style.display = isShown ? '' : 'none';
    }
    shownRows().forEach((row, i) => row.setAttribute('transform', places[i]));
    markRow();
  }

  /** Marks the latest row of the moment, and scrolls to it. */
  function markRow() {
    if (!$('messages').open) return;
    const now = shownRows().filter(row => Number(row.dataset.ms) <= nowMs + 1e-6).pop();
    for (const row of rows) row.classList.toggle('now', row === now);
    if (now) $('sequence').scrollTop = now.getBoundingClientRect().top - $('sequence').firstChild.getBoundingClientRect().top - $('sequence').clientHeight / 2;
  }

  function walkRows(event) {
    const shown = shownRows(), at = shown.findIndex(row => row.classList.contains('now'));
    const to = { ArrowUp: at - 1, ArrowDown: at + 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    if (shown[to]) shown[to].onclick();
  }

  const isGrowing = () => run.isOver === false;

  let isTouched = false;
  for (const kind of ['pointerdown', 'keydown']) document.addEventListener(kind, () => { isTouched = true; }, { once: true });

  /** Adds a part of a run that goes on; one without a speed opens at what went wrong, unless a person has begun. */
  function grow(part) {
    let isFound = false;
    for (const list of ['marks', 'texts', 'styles', 'frames']) run[list].push(...part[list]);
    for (const value of ['toMs', 'isOver', 'box']) run[value] = part[value];
    last = run.frames.length - 1;
    if (part.lanes) {
      run.lanes = part.lanes;
      drawLanes();
      run.sequence = part.sequence;
      drawSequence();
    }
    if (part.failure) {
      run.failure = part.failure;
      tellFailure(part.failure);
      isFound = !run.speed && !isTouched;
    }
    listTimes();
    if (isFound) follow();
    if (isFollowing && run.toMs - nowMs > FAR_MS * speed) nowMs = run.toMs;
    show();
  }

  /** Shows the latest moment, and goes on with the run. */
  function goLive() {
    seek(run.toMs);
    if (!isPlaying && isGrowing()) play();
    isFollowing = isGrowing();
  }

  function toViolation(isNext) {
    const times = run.marks.filter(mark => mark[1] === 'VIOLATION').map(mark => mark[0]);
    const wanted = isNext ? times.find(ms => ms > nowMs + 1e-6) : times.reverse().find(ms => ms < nowMs - 1e-6);
    if (wanted !== undefined) {
      pause();
      seek(wanted);
    }
  }

  // ---- what stands beside the canvas

  const seconds = ms => (ms / 1000).toFixed(3) + ' s';

  function describe(lists) {
    $('time').value = nowMs;
    if (run.lanes) $('now').style.left = laneScale() * inLanes(nowMs) + 'px';
    $('time').setAttribute('aria-valuetext', seconds(nowMs));
    markRow();
    $('clock').textContent = seconds(nowMs) + ' of ' + seconds(run.toMs);
    const violations = run.marks.filter(mark => mark[1] === 'VIOLATION' && mark[0] <= nowMs);
    const failed = run.failure && nowMs >= run.failure.ms - 1e-6 ? run.failure.headline : '';
    const latest = violations.length ? violations[violations.length - 1][2] : failed;
    tell($('message'), latest || (nowMs >= run.toMs && !isGrowing() ? 'The run ended at ' + seconds(run.toMs) : ''));
    $('message').className = latest ? 'alarm' : '';
    listRobots(lists[BODIES]);
    listState(lists[STATES].find(state => state[1] === selected));
  }

  function tell(element, text) {
    if (element.textContent !== text) element.textContent = text;
  }

  /** Keeps the elements that are there, so that the keyboard's focus stays. */
  function children(parent, count, make) {
    while (parent.childElementCount > count) parent.lastElementChild.remove();
    while (parent.childElementCount < count) parent.append(make());
    return parent.children;
  }

  function listRobots(bodies) {
    const rows = children($('robots'), bodies.length, () => {
      const row = document.createElement('li');
      row.append(document.createElement('button'));
      row.firstChild.append(document.createElement('i'), document.createElement('b'), ' ', document.createElement('span'));
      row.firstChild.onclick = () => select(Number(row.dataset.robot));
      return row;
    });
    $('find').hidden = bodies.length < MANY;
    const wanted = $('find').hidden ? '' : $('find').value.trim().toLowerCase();
    let stop = null;
    bodies.forEach((body, i) => {
      const button = rows[i].firstChild;
      rows[i].hidden = !(run.texts[body[1]] + ' ' + run.texts[body[3]]).toLowerCase().includes(wanted);
      if (!rows[i].hidden && (stop === null || body[1] === selected)) stop = button;
      rows[i].dataset.robot = body[1];
      button.setAttribute('aria-pressed', body[1] === selected);
      button.children[0].style.background = run.styles[body[2]][isDark ? 1 : 0];
      tell(button.children[1], run.texts[body[1]]);
      tell(button.children[2], run.texts[body[3]]);
    });
    // The list is one stop of the tab key; arrows lead from robot to robot.
    for (const row of rows) {
      const index = row.firstChild === stop ? 0 : -1;
      if (row.firstChild.tabIndex !== index) row.firstChild.tabIndex = index;
    }
  }

  function walkRobots(event) {
    const shown = [...$('robots').children].filter(row => !row.hidden);
    const at = shown.indexOf(event.target.closest('li'));
    const to = { ArrowUp: at - 1, ArrowDown: at + 1, Home: 0, End: shown.length - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const row = shown[Math.max(0, Math.min(shown.length - 1, to))];
    row.firstChild.focus();
    select(Number(row.dataset.robot));
  }

  function listState(state) {
    tell($('selected'), selected < 0 ? 'Select a robot' : run.texts[selected]);
    const count = state ? (state.length - 2) / 2 : 0;
    const rows = children($('state').tBodies[0], count, () => document.createElement('tr'));
    for (let i = 0; i < count; i++) {
      const name = state[2 + 2 * i], value = state[3 + 2 * i];
      const kind = value < 0 ? 'TH' : 'TD';
      if (!rows[i].firstChild || rows[i].firstChild.tagName !== kind) {
        rows[i].replaceChildren(document.createElement(kind), ...(value < 0 ? [] : [document.createElement(kind)]));
        if (value < 0) rows[i].firstChild.colSpan = 2;
      }
      tell(rows[i].children[0], run.texts[name]);
      if (value >= 0) tell(rows[i].children[1], run.texts[value]);
    }
  }

  /** What depends on the run's end: the time bar and its marks. */
  function listTimes() {
    Object.assign($('time'), { min: run.fromMs, max: run.toMs });
    $('next').disabled = !run.marks.some(mark => mark[1] === 'VIOLATION');
    $('live').hidden = !isGrowing();
    const marks = children($('marks'), run.marks.length, () => document.createElement('button'));
    run.marks.forEach(([ms, kind, text], i) => {
      const mark = marks[i];
      mark.className = kind;
      tell(mark, SIGNS[kind]);
      mark.title = seconds(ms) + ': ' + text;
      mark.setAttribute('aria-label', kind.toLowerCase() + ' at ' + mark.title);
      mark.style.left = 100 * (ms - run.fromMs) / Math.max(1, run.toMs - run.fromMs) + '%';
      mark.onclick = () => { pause(); seek(ms); link(); };
    });
  }

  function select(robot) {
    selected = robot;
    show();
    link();
    showLanes();
  }

  // ---- links: #t=34.1&robot=bot1

  /** Puts the moment and the robot into the address, which so can be shared. */
  function link() {
    const parts = ['t=' + Number((nowMs / 1000).toFixed(3))];
    if (selected >= 0) parts.push('robot=' + encodeURIComponent(run.texts[selected]));
    try {
      history.replaceState(null, '', '#' + parts.join('&'));
    } catch {
      // A page inside another has no address of its own.
    }
  }

  /** Goes where the address says, otherwise to what went wrong; unreadable parts are left out. */
  function follow() {
    const wanted = new URLSearchParams(location.hash.slice(1)), t = parseFloat(wanted.get('t'));
    const robot = wanted.get('robot') ?? (run.failure && !wanted.has('t') && run.failure.robots[0]?.robot);
    pause();
    selected = robot ? run.texts.indexOf(robot) : -1;
    seek(Number.isFinite(t) ? 1000 * t : run.failure ? run.failure.ms : run.fromMs);
    showLanes();
  }

  function tellFailure({ ms, headline, facts, commands }) {
    const button = document.createElement('button');
    button.textContent = headline;
    button.title = 'Go to ' + seconds(ms);
    button.onclick = () => { pause(); seek(ms); link(); };
    $('failure').append(button, ...facts.map(text => Object.assign(document.createElement('p'), { textContent: text })),
      ...commands.map(text => Object.assign(document.createElement('code'), { textContent: text })));
    $('failure').hidden = false;
  }

  function selectNeighbour(step) {
    const robots = picture(numberAt(nowMs))[BODIES].map(body => body[1]);
    if (robots.length === 0) return;
    const at = robots.indexOf(selected);
    select(robots[(at < 0 ? (step > 0 ? 0 : robots.length - 1) : at + step + robots.length) % robots.length]);
  }

  // ---- mouse and keyboard

  function zoom(factor, x, y) {
    const from = view || fitted();
    const scale = Math.max(0.05, Math.min(50, from.scale * factor));
    view = { scale, x: x - (x - from.x) * scale / from.scale, y: y - (y - from.y) * scale / from.scale };
    show();
  }

  function pan(dx, dy) {
    const from = view || fitted();
    view = { scale: from.scale, x: from.x + dx, y: from.y + dy };
    show();
  }

  function pick(event) {
    const { scale, x, y } = view || fitted();
    let best = -1, least = Infinity;
    for (const body of picture(numberAt(nowMs))[BODIES]) {
      const px = Math.hypot(body[5] / 10 * scale + x - event.offsetX, body[6] / 10 * scale + y - event.offsetY);
      if (px <= body[4] / 10 * scale + 6 && px < least) {
        least = px;
        best = body[1];
      }
    }
    select(best);
  }

  let drag = null;
  canvas.onpointerdown = event => {
    drag = { x: event.clientX, y: event.clientY, isFar: false };
    canvas.setPointerCapture(event.pointerId);
  };
  canvas.onpointermove = event => {
    if (!drag) return;
    drag.isFar = drag.isFar || Math.hypot(event.clientX - drag.x, event.clientY - drag.y) > 3;
    if (drag.isFar) {
      pan(event.clientX - drag.x, event.clientY - drag.y);
      drag.x = event.clientX;
      drag.y = event.clientY;
    }
  };
  canvas.onpointerup = event => {
    if (drag && !drag.isFar) pick(event);
    drag = null;
  };
  canvas.addEventListener('wheel', event => {
    event.preventDefault();
    zoom(Math.pow(1.15, -event.deltaY / 100), event.offsetX, event.offsetY);
  }, { passive: false });

  const fit = () => { view = null; show(); };
  const theme = () => { isDark = !isDark; dress(); };
  const faster = by => setSpeed(SPEEDS.indexOf(speed) + by);
  const centre = factor => zoom(factor, canvas.clientWidth / 2, canvas.clientHeight / 2);

  const KEYS = {
    ' ': () => isPlaying ? (pause(), link()) : play(),
    ArrowRight: event => event.ctrlKey ? pan(-40, 0) : event.shiftKey ? (pause(), seek(nowMs + 1000)) : step(1),
    ArrowLeft: event => event.ctrlKey ? pan(40, 0) : event.shiftKey ? (pause(), seek(nowMs - 1000)) : step(-1),
    ArrowUp: event => event.ctrlKey ? pan(0, 40) : faster(1),
    ArrowDown: event => event.ctrlKey ? pan(0, -40) : faster(-1),
    '.': () => step(1), ',': () => step(-1),
    Home: () => { isFollowing = false; seek(run.fromMs); }, End: () => { if (isGrowing()) goLive(); else { pause(); seek(run.toMs); } },
    n: () => toViolation(true), p: () => toViolation(false),
    Escape: () => select(-1), f: fit, d: theme,
    '+': () => centre(1.25), '=': () => centre(1.25), '-': () => centre(0.8)
  };

  document.addEventListener('keydown', event => {
    // Tab leaves the floor when no other robot follows, so that the keyboard is not caught there.
    if (event.key === 'Tab' && event.target === canvas) {
      const robots = picture(numberAt(nowMs))[BODIES].map(body => body[1]);
      const end = robots[event.shiftKey ? 0 : robots.length - 1];
      if (robots.length && selected !== end) {
        event.preventDefault();
        selectNeighbour(event.shiftKey ? -1 : 1);
      }
      return;
    }
    const isOwn = event.target.matches('select, summary, [type=search]') || (event.target.matches('button, input') && event.key === ' ');
    const act = KEYS[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (act && !isOwn && !event.altKey && !event.metaKey && (!event.ctrlKey || event.key.startsWith('Arrow'))) {
      event.preventDefault();
      act(event);
    }
  });

  function setSpeed(index) {
    speed = SPEEDS[Math.max(0, Math.min(SPEEDS.length - 1, index))];
    $('speed').value = speed;
  }

  function dress() {
    document.documentElement.dataset.theme = isDark ? 'dark' : 'light';
    $('theme').textContent = isDark ? 'Light' : 'Dark';
    show();
    drawLanes();
  }

  // ---- begin

  SPEEDS.forEach(value => $('speed').append(new Option(value + 'x', value)));
  setSpeed(SPEEDS.indexOf(1));
  $('speed').onchange = () => { speed = Number($('speed').value); };
  $('time').step = 'any';
  $('time').oninput = () => { pause(); seek(Number($('time').value)); };
  $('time').onchange = link;
  $('find').oninput = show;
  $('robots').onkeydown = walkRobots;
  drawSequence();
  $('messages').ontoggle = markRow;
  $('of').onchange = $('on').onchange = filterRows;
  $('sequence').onkeydown = walkRows;
  $('play').onclick = KEYS[' '];
  $('back').onclick = () => step(-1);
  $('forward').onclick = () => step(1);
  $('next').onclick = () => toViolation(true);
  $('live').onclick = goLive;
  $('fit').onclick = fit;
  $('theme').onclick = theme;
  listTimes();
  for (const [name, sections] of Object.entries(PARTS)) {
    const label = document.createElement('label'), box = document.createElement('input');
    Object.assign(box, { type: 'checkbox', checked: true, onchange: () => {
      sections.forEach(section => box.checked ? hidden.delete(section) : hidden.add(section));
      show();
    } });
    label.append(box, ' ' + name);
    $('parts').append(label);
  }
  if (run.failure) tellFailure(run.failure);
  new ResizeObserver(show).observe(canvas);
  new ResizeObserver(drawLanes).observe($('lanes'));
  dress();
  if (source && run.speed > 0 && isGrowing()) {
    const wanted = SPEEDS.findIndex(value => value >= run.speed);
    setSpeed(wanted < 0 ? SPEEDS.length : wanted);
    goLive();
  } else {
    follow();
    if (source) play();
  }
  window.onhashchange = follow;
  window.addEventListener('message', ({ source: from, data }) => {
    if (from !== parent || typeof data?.seekMs !== 'number') return;
    pause();
    seek(data.seekMs, true);
  });
  document.documentElement.dataset.ready = 'true';
})();
