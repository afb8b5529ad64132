package org.starl.lang.check;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.InflaterInputStream;

/**
 * What a search has visited, in a file: another process goes on from there. The file has a key of what was
 * searched, and then, compressed and with a checksum, the values that were met and the states. A search
 * ends early in the middle of a state's steps if there is no more room, so it is saved as it was
 * before them.
 */
public final class Checkpoint {

  private static final String FORMAT = "starl check 2";

  private final Search search;
  private final Counts counts;
  private int next = -1;
  private int states;
  private int end;
  private int depth;

  Checkpoint(Search search) {
    this.search = search;
    counts = new Counts(search.automaton.actions());
  }

  /** The search is saved as it is now. */
  void mark() {
    counts.set(search.counts);
    next = search.next;
    states = search.states.size();
    end = search.end;
    depth = search.depth;
  }

  /** Whether there is something to save: not where the start states alone were too many. */
  public boolean isMarked() {
    return next >= 0;
  }

  /**
   * Saves the search.
   *
   * @param key of what is searched, in one line
   */
  public void write(OutputStream to, String key) throws IOException {
    DataOutputStream head = new DataOutputStream(to);
    head.writeUTF(FORMAT);
    head.writeUTF(key);
    Deflater deflater = new Deflater(Deflater.BEST_SPEED);
    try {
      DeflaterOutputStream compressed = new DeflaterOutputStream(head, deflater);
      DataOutputStream out = new DataOutputStream(new BufferedOutputStream(compressed));
      search.symmetry.write(out);
      out.writeInt(states);
      search.states.write(states, out);
      out.writeInt(next);
      if (search.graph != null) {
        search.graph.write(next, out);
      }
      out.writeInt(end);
      out.writeInt(depth);
      counts.write(out);
      out.flush();
      compressed.finish();
    } finally {
      deflater.end();
    }
  }

  /** The key of a saved search; empty if the file is none. */
  public static String key(Path file) throws IOException {
    try (DataInputStream in = opened(file)) {
      return key(in);
    }
  }

  private static String key(DataInputStream in) throws IOException {
    for (char each : ("\0" + (char) FORMAT.length() + FORMAT).toCharArray()) {
      if (in.read() != each) {
        return "";
      }
    }
    return in.readUTF();
  }

  private static DataInputStream opened(Path file) throws IOException {
    return new DataInputStream(new BufferedInputStream(Files.newInputStream(file)));
  }

  /** What comes after the key. */
  private static DataInputStream content(DataInputStream in) throws IOException {
    key(in);
    return new DataInputStream(new BufferedInputStream(new InflaterInputStream(in)));
  }

  /**
   * The search goes on as it was saved. It has not begun yet.
   *
   * @throws IOException if the file is not complete, or damaged
   */
  public void read(Path file) throws IOException {
    try (DataInputStream in = content(opened(file))) {
      in.transferTo(OutputStream.nullOutputStream()); // compares the checksum
    }
    try (DataInputStream in = content(opened(file))) {
      search.symmetry.read(in);
      search.states.read(in.readInt(), in);
      search.next = in.readInt();
      if (search.graph != null) {
        search.graph.read(search.next, in);
      }
      search.end = in.readInt();
      search.depth = in.readInt();
      search.counts.read(in);
    }
  }
}
