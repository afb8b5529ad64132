package org.starl.android.apk;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Runs another program to its end. */
final class Tool {

  private Tool() {}

  /**
   * Returns all that it wrote.
   *
   * @throws ApkException if it is not there, or ends badly, with what it wrote
   */
  static String run(List<String> command) throws ApkException {
    try {
      Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
      process.getOutputStream().close();
      String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      int status = process.waitFor();
      if (status != 0) {
        throw ApkException.failed(
            command.get(0) + " ends with status " + status + ": " + output.strip());
      }
      return output;
    } catch (IOException e) {
      throw ApkException.missing(command.get(0) + " cannot be run: " + e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw ApkException.failed(command.get(0) + " was interrupted");
    }
  }
}
