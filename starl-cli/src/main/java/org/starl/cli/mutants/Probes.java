package org.starl.cli.mutants;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.InsnList;
import org.objectweb.asm.tree.LdcInsnNode;
import org.objectweb.asm.tree.LineNumberNode;
import org.objectweb.asm.tree.MethodInsnNode;

/** Which lines a run reaches: each line of a class gets a call that notes it. */
public final class Probes {

  private static final String OWN_NAME = Type.getInternalName(Probes.class);

  private static boolean[] isRun = new boolean[1 << 16];

  /** The number of each line, by file and line; from 0. */
  private final SortedMap<String, SortedMap<Integer, Integer>> numbers = new TreeMap<>();

  private int count;

  /** Called at the beginning of a line. */
  public static void reached(int number) {
    isRun[number] = true;
  }

  /** The class with a call at each line. */
  byte[] probed(byte[] bytes) {
    ClassReader reader = new ClassReader(bytes);
    ClassNode node = new ClassNode();
    reader.accept(node, 0);
    node.methods.forEach(method -> probe(method.instructions, node.sourceFile));
    ClassWriter writer = new ClassWriter(reader, ClassWriter.COMPUTE_MAXS);
    node.accept(writer);
    if (count > isRun.length) {
      isRun = Arrays.copyOf(isRun, 2 * count);
    }
    return writer.toByteArray();
  }

  private void probe(InsnList method, String file) {
    for (AbstractInsnNode one : method.toArray()) {
      AbstractInsnNode next = one;
      while (next != null && next.getOpcode() < 0) {
        next = next.getNext(); // a frame belongs to the instruction after it
      }
      if (one instanceof LineNumberNode line && next != null) {
        int number =
            numbers
                .computeIfAbsent(file, any -> new TreeMap<>())
                .computeIfAbsent(line.line, any -> count++);
        InsnList call = new InsnList();
        call.add(new LdcInsnNode(number));
        call.add(new MethodInsnNode(Opcodes.INVOKESTATIC, OWN_NAME, "reached", "(I)V"));
        if (next.getOpcode() == Opcodes.NEW) {
          method.insert(next, call); // later frames name its place
        } else {
          method.insertBefore(next, call);
        }
      }
    }
  }

  boolean isRun(String file, int line) {
    Integer number = numbers.getOrDefault(file, new TreeMap<>()).get(line);
    return number != null && isRun[number];
  }

  /** {@code Rover.java: 3 of 40 lines: 12, 17-18}, for each file with lines that no run reached. */
  List<String> neverRun() {
    List<String> files = new ArrayList<>();
    numbers.forEach((file, lines) -> {
      SortedSet<Integer> never = new TreeSet<>(lines.keySet());
      never.removeIf(line -> isRun(file, line));
      if (!never.isEmpty()) {
        files.add(
            "%s: %d of %d lines: %s".formatted(file, never.size(), lines.size(), ranges(never)));
      }
    });
    return files;
  }

  private static String ranges(SortedSet<Integer> lines) {
    List<String> ranges = new ArrayList<>();
    for (int first : lines) {
      if (!lines.contains(first - 1)) {
        int last = first;
        while (lines.contains(last + 1)) {
          last++;
        }
        ranges.add(first == last ? "" + first : first + "-" + last);
      }
    }
    return String.join(", ", ranges);
  }
}
