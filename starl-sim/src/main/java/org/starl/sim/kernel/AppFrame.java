package org.starl.sim.kernel;

import org.starl.LogicThread;
import org.starl.RobotApp;

/** Finds the line of an app's own code in a stack trace, for messages. */
public final class AppFrame {

  private static final String APP_METHOD = "callStarL";

  private AppFrame() {}

  /**
   * The innermost line of the app's class as {@code PatrolApp.java:83 (enter)}; of a handler, the
   * innermost line outside the simulator. Empty if there is none.
   */
  public static String of(StackTraceElement[] stack) {
    String app = "";
    for (StackTraceElement frame : stack) {
      if (frame.getMethodName().equals(APP_METHOD)) {
        app = outermost(frame);
      }
    }
    String found = "";
    for (StackTraceElement frame : stack) {
      boolean isOwn = app.isEmpty() ? !isFramework(frame) : outermost(frame).equals(app);
      if (isOwn && found.isEmpty()) {
        found =
            frame.getFileName() + ":" + frame.getLineNumber() + " (" + frame.getMethodName() + ")";
      }
      if ((isOwn && !app.isEmpty()) || isStrand(frame)) {
        return found;
      }
    }
    // An exception from elsewhere, such as one that was made before the run.
    return "";
  }

  private static boolean isStrand(StackTraceElement frame) {
    return frame.getClassName().equals(SimStrand.class.getName())
        && frame.getMethodName().equals("run");
  }

  private static String outermost(StackTraceElement frame) {
    String type = frame.getClassName();
    int nested = type.indexOf('$');
    return nested < 0 ? type : type.substring(0, nested);
  }

  private static boolean isFramework(StackTraceElement frame) {
    String type = frame.getClassName();
    return type.startsWith("java.")
        || type.startsWith("kotlin.")
        || type.startsWith("jdk.")
        || type.startsWith("org.starl.sim.kernel.")
        || type.startsWith("org.starl.sim.fault.")
        || type.equals(RobotApp.class.getName())
        || type.startsWith(LogicThread.class.getName());
  }
}
