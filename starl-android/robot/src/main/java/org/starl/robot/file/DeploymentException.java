package org.starl.robot.file;

/** A deployment file is not as it should be: one line for people names file, line, value and expected. */
public final class DeploymentException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  private static final int LONGEST = 1_000;

  /** @param message may quote the file: it is cut where long, and has no control characters then */
  public DeploymentException(String message) {
    super(oneLine(message));
  }

  private static String oneLine(String message) {
    int length = Math.min(message.length(), LONGEST);
    StringBuilder line = new StringBuilder(length);
    for (int i = 0; i < length; i++) {
      char c = message.charAt(i);
      line.append(Character.isISOControl(c) || c == 0x2028 || c == 0x2029 ? '?' : c);
    }
    return line.append(length < message.length() ? "..." : "").toString();
  }
}
