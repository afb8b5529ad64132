'use strict';
(() => {
  const $ = id => document.getElementById(id);
  const frames = [...document.querySelectorAll('iframe')], begun = new Set();
  const atMs = Number(document.body.dataset.at), toMs = Number($('time').max);
  let nowMs = 0, isPlaying = false;

  /** Shows a moment in both players, but for the one that told it. */
  function seek(ms, teller) {
    nowMs = Math.max(0, Math.min(toMs, ms));
    for (const frame of frames) if (frame.contentWindow !== teller) frame.contentWindow.postMessage({ seekMs: nowMs }, '*');
    $('time').value = nowMs;
    $('time').setAttribute('aria-valuetext', (nowMs / 1000).toFixed(3) + ' s');
    $('clock').textContent = (nowMs / 1000).toFixed(3) + ' s';
  }

  function pause() {
    isPlaying = false;
    $('play').textContent = 'Play';
  }

  $('play').onclick = () => {
    if (isPlaying) return pause();
    isPlaying = true;
    $('play').textContent = 'Pause';
    let realMs = performance.now();
    const fromMs = nowMs >= toMs ? 0 : nowMs;
    seek(fromMs);
    requestAnimationFrame(function tick(ms) {
      if (!isPlaying) return;
      seek(nowMs + Math.max(0, ms - realMs));
      realMs = ms;
      if (nowMs >= toMs) pause(); else requestAnimationFrame(tick);
    });
  };
  $('time').oninput = () => { pause(); seek(Number($('time').value)); };
  $('difference').onclick = () => { pause(); seek(atMs); };

  function heard({ source, data }) {
    if (!frames.some(frame => frame.contentWindow === source) || typeof data?.nowMs !== 'number') return;
    if (begun.size === frames.length) {
      pause();
      seek(data.nowMs, source);
    } else {
      begun.add(source);
      if (begun.size === frames.length) {
        seek(atMs);
        document.documentElement.dataset.ready = 'true';
      }
    }
  }
  early.forEach(heard); // of players that were ready before this script
  addEventListener('message', heard);
})();
