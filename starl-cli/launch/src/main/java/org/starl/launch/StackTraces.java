package org.starl.launch;

import java.io.PrintWriter;
import java.io.StringWriter;

/** Stack traces as text. */
public final class StackTraces {

  private StackTraces() {}

  public static String of(Throwable error) {
    StringWriter text = new StringWriter();
    try (PrintWriter writer = new PrintWriter(text)) {
      for (Throwable cause = error; cause != null; cause = cause.getCause()) {
        writer.println(cause);
        for (StackTraceElement frame : cause.getStackTrace()) {
          writer.println("    at " + frame);
        }
      }
    }
    return text.toString();
  }
}
