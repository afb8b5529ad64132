package org.starl.platform;

/** Receives log lines for people. The program's decisions never depend on them. */
public interface LogSink {

  /** The severity of a line. */
  enum Level {
    DEBUG,
    INFO,
    WARN,
    ERROR
  }

  void log(long timeNs, Level level, String tag, String line);
}
