package org.starl.cli.mutants;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.pitest.classpath.ClassPath;

/** A process with the options and the class path of this one, in which bugs are planted. */
public final class BugProcess implements AutoCloseable {

  private static final long LEAST_LIMIT_NS = TimeUnit.SECONDS.toNanos(5);
  private static final int LIMIT_FACTOR = 3;

  /** Options of this process that name caches of classes, which an agent makes useless. */
  private static final List<String> CACHES =
      List.of("-XX:AOT", "-XX:SharedArchiveFile", "-XX:ArchiveClassesAtExit", "-javaagent:");

  /** How the runs with a bug ended. */
  public enum Verdict {
    SURVIVED,
    FOUND,
    /** The JVM does not replace the class. */
    REFUSED
  }

  /**
   * A bug that was tried.
   *
   * @param text where and what it is
   * @param why the first bad run, or why it was refused; empty if it survived
   */
  public record Tried(String text, Verdict verdict, String why) {}

  /** A bug that can be tried, and whether a run reaches its line. */
  public record Bug(String text, boolean isRun) {}

  /**
   * What the runs are without a bug.
   *
   * @param bad the first bad run; empty if all are good
   * @param neverRun the lines that no run reaches, a text for each file
   */
  public record Without(String bad, int classes, List<Bug> bugs, List<String> neverRun) {}

  private final List<String> command = new ArrayList<>();
  private final Path folder;
  private volatile @Nullable Process process;
  private List<Bug> bugs = List.of();
  private long limitNs = Long.MAX_VALUE;

  /**
   * @param classes as {@link BugWorker#serve} gets them
   * @param words the main class, and the words for which it calls that
   * @throws org.starl.input.BadInput if there are no such classes
   */
  public BugProcess(String classes, List<String> words) throws IOException {
    Bugs.classes(new ClassPath(), classes);
    folder = Files.createTempDirectory("starl-mutants");
    Path agent = folder.resolve("agent.jar");
    Agent.writeJar(agent);
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    for (String option : ManagementFactory.getRuntimeMXBean().getInputArguments()) {
      if (CACHES.stream().noneMatch(option::startsWith)) {
        command.add(option);
      }
    }
    command.addAll(
        List.of(
            "-Xshare:auto", "-javaagent:" + agent, "-cp", System.getProperty("java.class.path")));
    command.addAll(words);
  }

  /** Runs without a bug; to be called first. */
  public Without without() throws IOException {
    try {
      DataInputStream in = ask(start(), BugWorker.NO_BUG);
      String bad = in.readUTF();
      long ns = in.readLong();
      limitNs = LEAST_LIMIT_NS + LIMIT_FACTOR * ns;
      int classes = in.readInt();
      List<Bug> all = new ArrayList<>();
      int count = in.readInt();
      for (int i = 0; i < count; i++) {
        all.add(new Bug(in.readUTF(), in.readBoolean()));
      }
      bugs = all;
      List<String> neverRun = new ArrayList<>();
      int files = in.readInt();
      for (int i = 0; i < files; i++) {
        neverRun.add(in.readUTF());
      }
      return new Without(bad, classes, all, neverRun);
    } catch (IOException e) {
      throw new IOException("the second process ended: " + errors(), e);
    }
  }

  /** Plants one bug and runs. Runs that take three times the usual time, and 5 s more, have found it. */
  public Tried with(int bug) throws IOException {
    Process asked = process == null ? start() : process;
    CompletableFuture<Void> answered = new CompletableFuture<>();
    answered
        .orTimeout(limitNs, TimeUnit.NANOSECONDS)
        .exceptionally(late -> {
          asked.destroyForcibly();
          return null;
        });
    String text = bugs.get(bug).text();
    try {
      DataInputStream in = ask(asked, bug);
      Verdict verdict = Verdict.values()[in.readInt()];
      return new Tried(text, verdict, in.readUTF());
    } catch (IOException e) {
      process = null;
      String why = answered.isDone() ? "does not end" : "ends the process";
      return new Tried(text, Verdict.FOUND, why);
    } finally {
      answered.complete(null);
    }
  }

  private Process start() throws IOException {
    File errors = folder.resolve("errors").toFile();
    Process started =
        new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.to(errors)).start();
    process = started;
    return started;
  }

  private static DataInputStream ask(Process asked, int bug) throws IOException {
    DataOutputStream out = new DataOutputStream(asked.getOutputStream());
    out.writeInt(bug);
    out.flush();
    return new DataInputStream(asked.getInputStream());
  }

  private String errors() throws IOException {
    String all = Files.readString(folder.resolve("errors"), StandardCharsets.UTF_8).strip();
    return all.lines().limit(1).findFirst().orElse("it printed nothing");
  }

  /** Ends the process. May be called from another thread. */
  public void end() {
    Process running = process;
    if (running != null) {
      running.destroyForcibly();
    }
  }

  @Override
  public void close() {
    end();
    File[] files = folder.toFile().listFiles();
    for (File file : files == null ? new File[0] : files) {
      file.delete();
    }
    folder.toFile().delete();
  }
}
