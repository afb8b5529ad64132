package org.starl.android.apk;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.starl.apps.AppFactory;
import org.starl.input.BadInput;
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
    line.setOverwrittenOptionsAllowed(true);
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
    SortedSet<String> apps = apps();
    Aapt2 linker = Aapt2.find(aapt2);
    SigningKey signingKey = signingKey();
    Levels levels = new Levels(Levels.MIN_SDK, Levels.TARGET_SDK, versionCode, "0.1.0");
    Path work = Files.createTempDirectory("starl-apk");
    try {
      Selection made = make(linker, signingKey, levels, work);
      printer.println(
          out + ": " + Files.size(out) / 1024 + " KiB, " + made.classes().size() + " classes");
      printer.println("apps: " + String.join(" ", apps));
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

  /** The names of the apps, found here as a phone finds them. */
  private static SortedSet<String> apps() throws ApkException {
    try {
      return new TreeSet<>(AppFactory.installed().keySet());
    } catch (BadInput e) {
      throw ApkException.badInput(String.valueOf(e.getMessage()));
    }
  }

  private Selection make(Aapt2 linker, SigningKey signingKey, Levels levels, Path work)
      throws ApkException, IOException {
    String classPath = System.getProperty("java.class.path", "");
    Path android = ClassPath.file(classPath, "android-all-");
    Selection selection = Selection.of(classPath);
    selection.refuseGaps(Android8.shapesBeforeD8(classPath));
    Path linked = work.resolve("linked.apk");
    Path frame = AppFrame.write(classPath, work.resolve("frame"));
    linker.link(
        frame.resolve("AndroidManifest.xml"), frame.resolve("res"), android, levels, work, linked);
    Path dex = Files.createDirectory(work.resolve("dex"));
    Dexer.dex(selection.classes(), android, levels.minSdk(), dex);
    Path unsigned = work.resolve("unsigned.apk");
    ApkFile.write(linked, dex, selection.apps(), unsigned);
    Path folder = out.toAbsolutePath().getParent();
    if (folder != null) {
      Files.createDirectories(folder);
    }
    Signing.sign(unsigned, signingKey, levels.minSdk(), out);
    return selection;
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
