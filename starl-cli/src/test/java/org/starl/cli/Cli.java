package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.starl.apps.Demos;
import org.starl.cli.command.Apps;
import org.starl.cli.command.ExitStatus;
import org.starl.launch.JavaProcess;

/**
 * The output of a command line, and its exit status.
 *
 * @param out lines on standard output
 * @param err lines on standard error
 */
public record Cli(int status, List<String> out, List<String> err) {

  private static final int HEAP_MB = 128;

  public static Cli run(String... args) {
    return run(Apps.ALL, args);
  }

  public static Cli run(Demos demos, String... args) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    int status = Main.run(demos, new PrintWriter(out), new PrintWriter(err), args);
    return new Cli(status, out.toString().lines().toList(), err.toString().lines().toList());
  }

  /** The words that start a command line in a process of its own. */
  public static List<String> process(String... args) {
    return JavaProcess.command(HEAP_MB, Main.class.getName(), List.of(args));
  }

  public String text() {
    return String.join("\n", out);
  }

  /** Standard error without the progress and the speed, which depend on the machine. */
  public List<String> messages() {
    return err.stream()
        .filter(line -> !line.matches("\\d+ of \\d+ .*|[0-9,]+ steps a second|bad so far: .*"))
        .toList();
  }

  public void assertSame(Cli expected) {
    assertThat(out).isEqualTo(expected.out);
    assertThat(messages()).isEqualTo(expected.messages());
    assertThat(status).isEqualTo(expected.status);
  }

  public void assertRefused(String... says) {
    assertThat(status).as("%s", this).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(messages()).as("%s", this).hasSize(1);
    assertThat(messages().getFirst()).startsWith("starl: ").contains(says);
  }

  /** Runs the words of {@code line}, and those of {@code more}. */
  public static Cli line(Demos demos, String line, Object... more) {
    List<String> words = new ArrayList<>(Arrays.asList(line.split(" ")));
    for (Object word : more) {
      words.add(word.toString());
    }
    return run(demos, words.toArray(String[]::new));
  }

  /** Runs a part of a command; its file in {@code folder}. */
  public static Path shard(Demos demos, Path folder, String line, int number, int count) {
    Path file = folder.resolve("part-" + number + "-of-" + count);
    Cli cli = line(demos, line + " --shard " + number + "/" + count + " --out", file);
    assertThat(cli.status()).as("%s", cli).isZero();
    return file;
  }

  /** Runs all parts of a command. */
  public static List<Path> shards(Demos demos, Path folder, String line, int count) {
    List<Path> files = new ArrayList<>();
    for (int i = 1; i <= count; i++) {
      files.add(shard(demos, folder, line, i, count));
    }
    return files;
  }

  /** Checks that {@code file} is resumed to the same bytes after each of some interruptions. */
  public static void assertResumes(Demos demos, String line, Path file) throws IOException {
    byte[] whole = Files.readAllBytes(file);
    String text = Files.readString(file);
    int header = text.indexOf('\n') + 1;
    int first = text.indexOf('\n', header) + 1;
    int second = text.indexOf('\n', first) + 1;
    int last = text.lastIndexOf('\n', text.length() - 2) + 1;
    for (int kept :
        List.of(0, 10, header - 1, header, second - 1, second, second + 99, last, whole.length)) {
      Files.write(file, Arrays.copyOf(whole, kept));
      Cli cli = line(demos, line + " --resume --out", file);
      // Its runs may be bad.
      assertThat(cli.status()).as("%s", cli).isLessThan(ExitStatus.BAD_INPUT);
      assertThat(Files.readAllBytes(file)).as("after %s bytes", kept).isEqualTo(whole);
    }
  }
}
