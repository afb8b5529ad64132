package org.starl.gvh;

import org.starl.platform.Clock;
import org.starl.platform.LogSink;
import org.starl.platform.LogSink.Level;

/** {@code gvh.log}: log lines for people. */
public final class Log {

  private final Clock clock;
  private final LogSink sink;

  public Log(Clock clock, LogSink sink) {
    this.clock = clock;
    this.sink = sink;
  }

  public void d(String tag, String line) {
    sink.log(clock.nowNs(), Level.DEBUG, tag, line);
  }

  public void i(String tag, String line) {
    sink.log(clock.nowNs(), Level.INFO, tag, line);
  }

  public void w(String tag, String line) {
    sink.log(clock.nowNs(), Level.WARN, tag, line);
  }

  public void e(String tag, String line) {
    sink.log(clock.nowNs(), Level.ERROR, tag, line);
  }
}
