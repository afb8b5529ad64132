package org.starl.launch;

import static org.starl.time.Time.NS_PER_S;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.starl.platform.Clock;

/**
 * Log lines that strangers can cause, at most one a second for each kind, so that they fill no disk. A
 * line says how many were left out before it. From any thread.
 */
final class LimitedLog {

  private static final class Kind {
    private long lastNs;
    private long leftOut;
  }

  private final Clock clock;
  private final Consumer<String> console;
  private final Map<String, Kind> kinds = new TreeMap<>();

  LimitedLog(Clock clock, Consumer<String> console) {
    this.clock = clock;
    this.console = console;
  }

  /** Logs {@code line} or leaves it out. There are few kinds. */
  synchronized void log(String name, String line) {
    long nowNs = clock.nowNs();
    Kind kind = kinds.get(name);
    if (kind != null && nowNs - kind.lastNs < NS_PER_S) {
      kind.leftOut++;
      return;
    }
    if (kind == null) {
      kind = new Kind();
      kinds.put(name, kind);
    }
    console.accept(kind.leftOut == 0 ? line : line + " (and " + kind.leftOut + " before it)");
    kind.lastNs = nowNs;
    kind.leftOut = 0;
  }
}
