package org.starl.platform;

/** Takes log lines for people. Nothing that decides reads them. */
public interface LogSink {

  /** How serious a line is. */
  enum Level {
    DEBUG,
    INFO,
    WARN,
    ERROR
  }

  void log(long timeNs, Level level, String tag, String line);
}
