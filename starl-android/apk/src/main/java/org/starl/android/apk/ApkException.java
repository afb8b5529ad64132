package org.starl.android.apk;

/** The APK could not be made; the message is one line for people. */
final class ApkException extends Exception {

  private static final long serialVersionUID = 1L;

  private final int exitStatus;

  private ApkException(int exitStatus, String message) {
    super(message);
    this.exitStatus = exitStatus;
  }

  /** A failure caused neither by input nor by the machine's setup. */
  static ApkException failed(String message) {
    return new ApkException(1, message);
  }

  /** The user's input cannot be used. */
  static ApkException badInput(String message) {
    return new ApkException(2, message);
  }

  /** The machine lacks something. */
  static ApkException missing(String message) {
    return new ApkException(3, message);
  }

  int exitStatus() {
    return exitStatus;
  }
}
