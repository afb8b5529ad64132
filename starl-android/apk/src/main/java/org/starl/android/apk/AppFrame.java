package org.starl.android.apk;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** The phone app's manifest and resources: files beside its classes. */
final class AppFrame {

  private static final String FOLDER = "org/starl/android/app/apk/";

  private AppFrame() {}

  /**
   * Writes the manifest and the folder {@code res}.
   *
   * @return {@code folder}
   */
  static Path write(String classPath, Path folder) throws IOException {
    try (ClassPath path = ClassPath.open(classPath, "android-all-")) {
      for (String name : path.names()) {
        byte[] bytes = name.startsWith(FOLDER) ? path.bytes(name) : null;
        if (bytes != null) {
          Path file = folder.resolve(name.substring(FOLDER.length()));
          Files.createDirectories(file.getParent());
          Files.write(file, bytes);
        }
      }
    }
    return folder;
  }
}
