package org.starl.android.apk;

import com.android.tools.r8.CompilationFailedException;
import com.android.tools.r8.CompilationMode;
import com.android.tools.r8.D8;
import com.android.tools.r8.D8Command;
import com.android.tools.r8.Diagnostic;
import com.android.tools.r8.DiagnosticsHandler;
import com.android.tools.r8.JdkClassFileProvider;
import com.android.tools.r8.OutputMode;
import com.android.tools.r8.origin.Origin;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;

/** Makes dex of classes. */
final class Dexer {

  private Dexer() {}

  /**
   * Writes {@code classes.dex}, and more of them if one is full, into {@code folder}.
   *
   * @param android a jar with Android's classes
   */
  static void dex(SortedMap<String, byte[]> classes, Path android, int minSdk, Path folder)
      throws ApkException, IOException {
    Findings findings = new Findings();
    D8Command.Builder command =
        D8Command.builder(findings)
            .addLibraryFiles(android)
            // Android's jar omits java.lang.
            .addLibraryResourceProvider(
                JdkClassFileProvider.fromJdkHome(Path.of(System.getProperty("java.home"))))
            .setMinApiLevel(minSdk)
            .setMode(CompilationMode.RELEASE)
            .setOutput(folder, OutputMode.DexIndexed);
    classes.forEach((name, bytes) -> command.addClassProgramData(bytes, Origin.unknown()));
    try {
      D8.run(command.build());
    } catch (CompilationFailedException e) {
      throw ApkException.failed("D8: " + e.getMessage() + " " + findings.lines);
    }
    if (!findings.lines.isEmpty()) {
      throw ApkException.failed("D8 warns: " + findings.lines);
    }
  }

  /** A warning is an error: otherwise only a phone would find that a class is missing. */
  private static final class Findings implements DiagnosticsHandler {

    private final List<String> lines = new ArrayList<>();

    @Override
    public void error(Diagnostic diagnostic) {
      lines.add(diagnostic.getDiagnosticMessage());
    }

    @Override
    public void warning(Diagnostic diagnostic) {
      lines.add(diagnostic.getDiagnosticMessage());
    }

    @Override
    public void info(Diagnostic diagnostic) {
      // Not relevant for users.
    }
  }
}
