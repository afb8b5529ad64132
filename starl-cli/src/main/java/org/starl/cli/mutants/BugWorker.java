package org.starl.cli.mutants;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.cli.mutants.BugProcess.Verdict;

/** The process in which bugs are planted. It does what the other one asks, until that ends. */
public final class BugWorker {

  /** The question that is no bug's number: which lines runs reach without a bug. */
  static final int NO_BUG = -1;

  /** The runs that are to find a bug. */
  @FunctionalInterface
  public interface Runs {

    /** What the first bad run was, with its seed; empty if all were good. */
    String firstBad() throws InterruptedException;
  }

  private final Bugs bugs;
  private final Runs runs;

  private BugWorker(Bugs bugs, Runs runs) {
    this.bugs = bugs;
    this.runs = runs;
  }

  /** Answers on the standard output. All else is printed to the standard error. */
  public static void serve(String classes, Runs runs) throws IOException, InterruptedException {
    System.setOut(System.err);
    BugWorker worker = new BugWorker(new Bugs(classes), runs);
    DataInputStream in = new DataInputStream(System.in);
    try (DataOutputStream out = new DataOutputStream(new FileOutputStream(FileDescriptor.out))) {
      while (true) {
        int bug = in.readInt();
        if (bug == NO_BUG) {
          worker.answerWithoutBug(out);
        } else {
          worker.answer(bug, out);
        }
        out.flush();
      }
    } catch (EOFException e) {
      return; // the other process has ended
    }
  }

  private void answerWithoutBug(DataOutputStream out) throws IOException, InterruptedException {
    Probes probes = new Probes();
    Map<String, byte[]> probed = new TreeMap<>();
    for (String name : bugs.classes()) {
      Map<String, byte[]> one = Map.of(name, probes.probed(bugs.bytes(name)));
      Agent.redefine(one);
      probed.putAll(one);
    }
    out.writeUTF(runs.firstBad());
    probed.replaceAll((name, bytes) -> bugs.bytes(name));
    Agent.redefine(probed);
    long beganNs = System.nanoTime();
    runs.firstBad();
    out.writeLong(System.nanoTime() - beganNs);
    out.writeInt(bugs.classes().size());
    out.writeInt(bugs.count());
    for (int bug = 0; bug < bugs.count(); bug++) {
      out.writeUTF(bugs.text(bug));
      out.writeBoolean(probes.isRun(bugs.file(bug), bugs.line(bug)));
    }
    List<String> neverRun = probes.neverRun();
    out.writeInt(neverRun.size());
    for (String file : neverRun) {
      out.writeUTF(file);
    }
  }

  private void answer(int bug, DataOutputStream out) throws IOException, InterruptedException {
    String name = bugs.className(bug);
    try {
      Agent.redefine(bugs.planted(bug));
    } catch (UnsupportedOperationException | LinkageError e) {
      out.writeInt(Verdict.REFUSED.ordinal());
      out.writeUTF(e.toString());
      return;
    }
    String bad = firstBad();
    Agent.redefine(Map.of(name, bugs.bytes(name)));
    out.writeInt((bad.isEmpty() ? Verdict.SURVIVED : Verdict.FOUND).ordinal());
    out.writeUTF(bad);
  }

  /** An error of a bug's making ends the runs, and not this process. */
  private String firstBad() throws InterruptedException {
    try {
      return runs.firstBad();
    } catch (StackOverflowError | OutOfMemoryError | LinkageError | RuntimeException e) {
      return e.toString();
    }
  }
}
