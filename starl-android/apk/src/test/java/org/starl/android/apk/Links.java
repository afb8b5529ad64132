package org.starl.android.apk;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

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
      new ClassReader(classes.get(name)).accept(links.new Look(name), 0);
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
          public FieldVisitor visitField(
              int access, String name, String type, String signature, Object value) {
            members.add(name + "#" + type);
            return null;
          }

          @Override
          public MethodVisitor visitMethod(
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

  private final class Look extends ClassVisitor {
    private final String from;

    Look(String from) {
      super(Opcodes.ASM9);
      this.from = from;
    }

    private void type(String name) {
      type(Type.getObjectType(name));
    }

    private void type(Type type) {
      switch (type.getSort()) {
        case Type.ARRAY -> type(type.getElementType());
        case Type.METHOD -> {
          type(type.getReturnType());
          for (Type argument : type.getArgumentTypes()) {
            type(argument);
          }
        }
        case Type.OBJECT -> {
          if (!shapes.containsKey(type.getInternalName())) {
            missing.add(from + " -> " + type.getInternalName());
          }
        }
        default -> {}
      }
    }

    private void member(String owner, String member) {
      // An array's clone() and length are the language's.
      if (owner.startsWith("[")) {
        return;
      }
      type(owner);
      if (shapes.containsKey(owner) && !has(owner, member)) {
        missing.add(from + " -> " + owner + "." + member);
      }
    }

    @Override
    public void visit(
        int version,
        int access,
        String name,
        String signature,
        String parent,
        String[] interfaces) {
      type(parent);
      for (String each : interfaces) {
        type(each);
      }
    }

    @Override
    public FieldVisitor visitField(
        int access, String name, String type, String signature, Object value) {
      type(Type.getType(type));
      return null;
    }

    @Override
    public MethodVisitor visitMethod(
        int access, String name, String type, String signature, String[] exceptions) {
      type(Type.getMethodType(type));
      return new Code(this);
    }
  }

  private static final class Code extends MethodVisitor {
    private final Look look;

    Code(Look look) {
      super(Opcodes.ASM9);
      this.look = look;
    }

    @Override
    public void visitMethodInsn(
        int opcode, String owner, String name, String type, boolean isInterface) {
      look.member(owner, name + type);
      look.type(Type.getMethodType(type));
    }

    @Override
    public void visitFieldInsn(int opcode, String owner, String name, String type) {
      look.member(owner, name + "#" + type);
    }

    @Override
    public void visitTypeInsn(int opcode, String type) {
      look.type(type);
    }

    @Override
    public void visitMultiANewArrayInsn(String type, int dimensions) {
      look.type(Type.getType(type));
    }

    @Override
    public void visitTryCatchBlock(Label start, Label end, Label handler, String type) {
      if (type != null) {
        look.type(type);
      }
    }

    @Override
    public void visitLdcInsn(Object value) {
      if (value instanceof Type type) {
        look.type(type);
      }
    }

    @Override
    public void visitInvokeDynamicInsn(
        String name, String type, Handle bootstrap, Object... arguments) {
      throw new IllegalStateException(look.from + " has invokedynamic, which dex 38 has not");
    }
  }
}
