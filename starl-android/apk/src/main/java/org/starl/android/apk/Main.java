package org.starl.android.apk;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SortedMap;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code starl apk}. */
@Command(
    name = "starl apk",
    description = "Makes the APK of the app for phones, signs and verifies it; needs aapt2.",
    mixinStandardHelpOptions = true,
    footer = {"", "Example: starl apk --out out/starl.apk"})
public final class Main implements Callable<Integer> {

  @Option(
      names = "--project",
      paramLabel = "FOLDER",
      hidden = true,
      description = "StarL's own folder; the launcher gives it.")
  private Path project = Path.of("");

  @Option(
      names = "--out",
      paramLabel = "FILE",
      description = "Where the APK goes (default: ${DEFAULT-VALUE}).")
  private Path out = Path.of("out", "starl.apk");

  @Option(names = "--aapt2", paramLabel = "PATH", description = "The aapt2 to link with.")
  private @Nullable Path aapt2;

  @Option(
      names = "--key",
      paramLabel = "FILE",
      description =
          "A PKCS12 file to sign with; without it a debug key, made in ~/.starl when first needed.")
  private @Nullable Path key;

  @Option(
      names = "--key-password-file",
      paramLabel = "FILE",
      description = "Its first line is the password of --key.")
  private @Nullable Path passwordFile;

  @Option(
      names = "--key-alias",
      paramLabel = "NAME",
      description = "Which key of --key (default: ${DEFAULT-VALUE}).")
  private String alias = "starl";

  @Option(
      names = "--version-code",
      paramLabel = "N",
      description = "A phone updates to no lower number (default: ${DEFAULT-VALUE}).")
  private int versionCode = 1;

  @Option(names = "--badging", description = "Also print all that aapt2 reads from the APK.")
  private boolean badging;

  @Spec private @Nullable CommandSpec spec;

  public static void main(String[] args) {
    PrintWriter out = new PrintWriter(System.out, true, StandardCharsets.UTF_8);
    PrintWriter err = new PrintWriter(System.err, true, StandardCharsets.UTF_8);
    System.exit(run(out, err, args));
  }

  /** Runs the command and returns its exit status. */
  static int run(PrintWriter out, PrintWriter err, String... args) {
    CommandLine line = new CommandLine(new Main()).setOut(out).setErr(err);
    line.setParameterExceptionHandler(Main::refuse);
    line.setExecutionExceptionHandler(Main::report);
    return line.execute(args);
  }

  private static int refuse(ParameterException error, String[] args) {
    String first = String.valueOf(error.getMessage()).lines().findFirst().orElse("bad arguments");
    error.getCommandLine().getErr().println("starl: apk: " + first);
    return 2;
  }

  private static int report(Exception error, CommandLine line, CommandLine.ParseResult parsed)
      throws Exception {
    if (error instanceof ApkException expected) {
      line.getErr().println("starl: apk: " + expected.getMessage());
      return expected.exitStatus();
    }
    if (error instanceof IOException) {
      line.getErr().println("starl: apk: " + error);
      return 1;
    }
    throw error;
  }

  @Override
  public Integer call() throws ApkException, IOException {
    if (spec == null) {
      throw new IllegalStateException("picocli has not said what it runs");
    }
    PrintWriter printer = spec.commandLine().getOut();
    Aapt2 linker = Aapt2.find(aapt2);
    SigningKey signingKey = signingKey();
    Levels levels = new Levels(Levels.MIN_SDK, Levels.TARGET_SDK, versionCode, "0.1.0");
    Path work = Files.createTempDirectory("starl-apk");
    try {
      SortedMap<String, byte[]> classes = make(linker, signingKey, levels, work);
      printer.println(out + ": " + Files.size(out) / 1024 + " KiB, " + classes.size() + " classes");
    } finally {
      Folders.delete(work);
    }
    printer.println(Signing.verify(out, levels.minSdk()));
    for (String line : linker.badging(out)) {
      if (badging || line.startsWith("package:") || line.startsWith("launchable")) {
        printer.println(line);
      }
    }
    return 0;
  }

  private SortedMap<String, byte[]> make(
      Aapt2 linker, SigningKey signingKey, Levels levels, Path work)
      throws ApkException, IOException {
    String classPath = System.getProperty("java.class.path", "");
    Path android = Selection.jar(classPath, "android-all-");
    SortedMap<String, byte[]> classes = Selection.classes(classPath);
    Path sources = project.resolve(Path.of("starl-android", "app", "src", "main"));
    Path linked = work.resolve("linked.apk");
    linker.link(
        sources.resolve("AndroidManifest.xml"),
        sources.resolve("res"),
        android,
        levels,
        work,
        linked);
    Path dex = Files.createDirectory(work.resolve("dex"));
    Dexer.dex(classes, android, levels.minSdk(), dex);
    Path unsigned = work.resolve("unsigned.apk");
    ApkFile.write(linked, dex, unsigned);
    Path folder = out.toAbsolutePath().getParent();
    if (folder != null) {
      Files.createDirectories(folder);
    }
    Signing.sign(unsigned, signingKey, levels.minSdk(), out);
    return classes;
  }

  private SigningKey signingKey() throws ApkException, IOException {
    Path file = key;
    if (file == null) {
      return SigningKey.debug(Path.of(System.getProperty("user.home"), ".starl"));
    }
    Path password = passwordFile;
    if (password == null) {
      throw ApkException.badInput("--key needs --key-password-file");
    }
    return SigningKey.read(file, SigningKey.password(password), alias);
  }
}
