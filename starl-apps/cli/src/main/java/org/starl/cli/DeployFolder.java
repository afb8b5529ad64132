package org.starl.cli;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.starl.input.BadInput;

/** Where a deployment's process leaves traces and keeps what must survive it. */
record DeployFolder(Path path) {

  private static final int MAX_STARTS = 10_000;

  /** @throws BadInput if there is none, and none can be made */
  static DeployFolder of(String name) {
    Path path = Path.of(name);
    try {
      Files.createDirectories(path);
    } catch (IOException e) {
      throw new BadInput("--folder: " + name + ": " + e.getMessage() + "; expected a folder");
    }
    return new DeployFolder(path);
  }

  /** The storage of a robot. */
  Path storage(String robot) {
    return path.resolve(robot + ".storage");
  }

  /** A new trace: {@code bot0.trace}, or {@code bot0.2.trace} where that is there already. */
  OutputStream trace(String who) throws IOException {
    for (int start = 1; start < MAX_STARTS; start++) {
      Path file = path.resolve(who + (start == 1 ? "" : "." + start) + ".trace");
      if (!Files.exists(file)) {
        return new BufferedOutputStream(
            Files.newOutputStream(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE));
      }
    }
    throw new IOException(path + " is full of traces");
  }
}
