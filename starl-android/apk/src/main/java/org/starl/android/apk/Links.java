package org.starl.android.apk;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/**
 * What classes refer to and neither they nor a platform have. A member may be inherited: a call of an
 * own class's method that only a newer Android's class above it has is found as well.
 */
final class Links {

  /**
   * The members of a class that can be referred to.
   *
   * @param parents names of its superclass and interfaces
   * @param members fields as {@code name#type}, methods as {@code name(types)type}
   */
  record Shape(List<String> parents, Set<String> members) {}

  private final SortedMap<String, Shape> shapes;
  private final SortedSet<String> missing = new TreeSet<>();

  private Links(SortedMap<String, Shape> platform) {
    shapes = new TreeMap<>(platform);
  }

  /**
   * Each thing that is missing: {@code from -> what}.
   *
   * @param classes class files that are there
   * @param looked names of those that are looked at
   */
  static SortedSet<String> missing(
      SortedMap<String, byte[]> classes, Collection<String> looked, SortedMap<String, Shape> on) {
    Links links = new Links(on);
    classes.values().forEach(links::learn);
    for (String name : looked) {
      References.of(Objects.requireNonNull(classes.get(name), name), new Look(links, name));
    }
    return links.missing;
  }

  private void learn(byte[] bytes) {
    ClassReader reader = new ClassReader(bytes);
    List<String> parents = new ArrayList<>(List.of(reader.getInterfaces()));
    parents.add(reader.getSuperName());
    Set<String> members = new TreeSet<>();
    reader.accept(
        new ClassVisitor(Opcodes.ASM9) {
          @Override
          public @Nullable FieldVisitor visitField(
              int access, String name, String type, String signature, Object value) {
            members.add(name + "#" + type);
            return null;
          }

          @Override
          public @Nullable MethodVisitor visitMethod(
              int access, String name, String type, String signature, String[] exceptions) {
            members.add(name + type);
            return null;
          }
        },
        ClassReader.SKIP_CODE);
    shapes.put(reader.getClassName(), new Shape(parents, members));
  }

  private boolean has(String owner, String member) {
    Shape shape = shapes.get(owner);
    if (shape == null) {
      return false;
    }
    return shape.members().contains(member)
        || shape.parents().stream().anyMatch(parent -> has(parent, member))
        || (shape.parents().isEmpty() && !owner.equals(OBJECT) && has(OBJECT, member));
  }

  private static final String OBJECT = "java/lang/Object";

  /** Takes the references of one class. */
  private record Look(Links links, String from) implements References.Listener {

    @Override
    public void type(String name) {
      if (!links.shapes.containsKey(name)) {
        links.missing.add(from + " -> " + name);
      }
    }

    @Override
    public void member(String owner, String member) {
      if (links.shapes.containsKey(owner) && !links.has(owner, member)) {
        links.missing.add(from + " -> " + owner + "." + member);
      }
    }
  }
}
