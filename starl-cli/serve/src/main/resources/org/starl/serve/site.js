'use strict';
(async () => {
  const $ = id => document.getElementById(id);
  const COMMON = ['robots', 'duration', 'messageLoss', 'messageDelay', 'positionNoise', 'chaos'];
  const POLL_MS = 400;

  function make(name, properties = {}, ...children) {
    const element = Object.assign(document.createElement(name), properties);
    element.append(...children);
    return element;
  }

  const tell = text => { $('error').textContent = text; };

  async function ask(address, body) {
    const how = body && { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(body) };
    const answer = await fetch(address, how);
    if (!answer.ok) throw new Error(await answer.text());
    return answer.json();
  }

  /** A run in a frame of its own, with the command that makes it. */
  async function show(request, note) {
    const { number } = await ask('/api/runs', request);
    const { runs } = await ask('/api/overview');
    const { title, command } = runs.find(run => run.number === number);
    const article = make('article', {},
      make('header', {}, make('h2', { textContent: title }), make('p', { textContent: note }), make('code', { textContent: command })),
      make('iframe', { src: '/run/' + number, title: 'Run ' + number + ': ' + title }));
    $('runs').append(article);
    if (article.getBoundingClientRect().top > innerHeight / 2) article.scrollIntoView(); // below a form or a table
  }

  // ---- the playground

  async function playground() {
    const schema = await ask('/api/schema');
    const rules = Object.fromEntries(schema.allOf.map(rule => [rule.if.properties.app.const, rule.then]));
    const { app: apps, faults, ...settings } = schema.properties;
    const shown = []; // the requests beside each other
    let before = []; // of a link: what Run starts before the run of the form

    /** A field for one key; empty is the default. */
    function field(key, form) {
      const about = form.description || '', standard = form.default === undefined ? '' : String(form.default);
      const input = form.enum
        ? make('select', {}, new Option(standard ? 'default: ' + standard : 'default', ''), ...form.enum.map(value => new Option(value)))
        : make('input', { placeholder: standard });
      Object.assign(input, { name: key, title: about, oninput: () => input.classList.toggle('set', input.value !== '') });
      return make('label', { title: about }, key, input);
    }

    function listParameters() {
      const app = $('app').value;
      $('summary').textContent = rules[app].description;
      const own = Object.entries(rules[app].properties);
      $('parameters').replaceChildren(...own.length ? own.map(([key, form]) => field(key, form)) : ['none']);
    }

    function fields() {
      return [...$('form').querySelectorAll('[name]')];
    }

    function read() {
      const set = {};
      for (const input of fields()) if (input.value.trim()) set[input.name] = input.value.trim();
      const lines = $('faults').value.split('\n').map(line => line.trim()).filter(line => line);
      return { app: $('app').value, seed: $('seed').value.trim(), set, faults: lines };
    }

    function fill(request) {
      $('app').value = request.app;
      listParameters();
      $('seed').value = request.seed;
      $('faults').value = request.faults.join('\n');
      for (const input of fields()) {
        input.value = request.set[input.name] || '';
        input.oninput();
      }
    }

    /** A request in the words of a link. */
    function words({ app, seed, set, faults: all }) {
      return new URLSearchParams([['app', app], ['seed', seed], ...Object.entries(set).map(([key, value]) => ['set.' + key, value]), ...all.map(fault => ['fault', fault])]).toString();
    }

    function request(text) {
      const given = new URLSearchParams(text), set = {};
      for (const [key, value] of given) if (key.startsWith('set.')) set[key.slice(4)] = value;
      return { app: given.get('app'), seed: given.get('seed'), set, faults: given.getAll('fault') };
    }

    /** Fills the form from a link, and says what Run starts. */
    function open(linked) {
      const last = linked[linked.length - 1];
      const unknown = linked.map(each => each.app).filter(app => !rules[app]);
      if (unknown.length) throw new Error('The link has an app that is not here: ' + unknown.join(', '));
      fill(last);
      const keys = fields().map(input => input.name), others = Object.keys(last.set).filter(key => !keys.includes(key));
      if (others.length) throw new Error('The link has settings that are not here: ' + others.join(', '));
      before = linked.slice(0, -1);
      const text = ({ app, seed, set, faults: all }) => [app, 'seed ' + seed, ...Object.entries(set).map(pair => pair.join('=')), ...all].join(', ');
      $('linked').textContent = (before.length ? 'Run starts the ' + linked.length + ' runs of this link: ' : 'Run starts the run of this link: ') + linked.map(text).join('; ');
    }

    async function runAll() {
      const all = [...before, read()];
      before = [];
      $('linked').textContent = '';
      for (let i = 0; i < all.length; i++) await run(all[i], i > 0);
    }

    function difference(a, b) {
      const changes = [], flat = ({ app, seed, set, faults: all }) => ({ app, seed, ...set, faults: all.join(' ') });
      const before = flat(a), after = flat(b);
      for (const key of new Set([...Object.keys(before), ...Object.keys(after)])) {
        if (before[key] !== after[key]) changes.push(key + ': ' + (before[key] || 'default') + ' \u2192 ' + (after[key] || 'default'));
      }
      return changes.length ? 'changed: ' + changes.join(', ') : '';
    }

    async function run(wanted, isBeside) {
      tell('');
      if (!isBeside) {
        $('runs').replaceChildren();
        shown.length = 0;
      }
      try {
        await show(wanted, shown.length ? difference(shown[0], wanted) : '');
        shown.push(wanted);
        history.replaceState(null, '', '#' + new URLSearchParams(shown.map(each => ['run', words(each)])));
      } catch (error) {
        tell(error.message);
      }
    }

    apps.enum.forEach(app => $('app').append(new Option(app)));
    $('app').onchange = listParameters;
    $('settings').append(...COMMON.filter(key => settings[key]).map(key => field(key, settings[key])));
    $('more').append(...Object.entries(settings).filter(([key]) => !COMMON.includes(key)).map(([key, form]) => field(key, form)));
    $('kinds').textContent = faults.description || '';
    $('form').onsubmit = event => { event.preventDefault(); runAll(); };
    $('beside').onclick = () => run(read(), true);
    $('app').value = apps.enum.includes('intersection') ? 'intersection' : apps.enum[0];
    listParameters();
    window.onhashchange = () => location.reload(); // a link that is opened in this tab
    const linked = new URLSearchParams(location.hash.slice(1)).getAll('run').map(request);
    if (linked.length) open(linked);
  }

  // ---- the campaign

  async function campaign() {
    let listed = 0, drawn = 0;

    async function look() {
      const { campaign: now } = await ask('/api/overview');
      $('title').textContent = 'Campaign: ' + now.app;
      $('state').textContent = now.done + ' of ' + now.planned + ' runs, ' + now.bad + ' bad' + (now.isEnded ? ', ended' : '');
      Object.assign($('progress'), { max: now.planned, value: now.done });
      for (; drawn < now.verdicts.length; drawn++) $('squares').append(make('i', { className: now.verdicts[drawn] }));
      for (; listed < now.rows.length; listed++) {
        const { seed, detail, replay } = now.rows[listed];
        const open = make('button', { textContent: String(seed), title: 'Play the run of seed ' + seed, onclick: () => {
          tell('');
          $('runs').replaceChildren();
          show({ seed }, detail).catch(error => tell(error.message));
        } });
        $('bad').tBodies[0].append(make('tr', {}, make('td', {}, open), make('td', { textContent: detail }), make('td', {}, make('code', { textContent: replay }))));
      }
      $('none').hidden = listed > 0;
      if (now.isEnded && !listed) $('none').textContent = 'None.';
      if (!now.isEnded) setTimeout(() => look().catch(error => tell(error.message)), POLL_MS);
    }
    await look();
  }

  try {
    await (document.body.dataset.page === 'campaign' ? campaign() : playground());
  } catch (error) {
    tell(error.message);
  }
  document.documentElement.dataset.ready = 'true';
})();
