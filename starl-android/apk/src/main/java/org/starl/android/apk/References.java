package org.starl.android.apk;

import org.jspecify.annotations.Nullable;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/** All that a class file refers to, besides its annotations. */
final class References extends ClassVisitor {

  /** Takes the references, some of them several times. */
  interface Listener {

    /** A class, by its name with slashes. */
    void type(String name);

    /**
     * A member of a class that was given before.
     *
     * @param member a field as {@code name#type}, a method as {@code name(types)type}
     */
    void member(String owner, String member);
  }

  private final Listener listener;

  private References(Listener listener) {
    super(Opcodes.ASM9);
    this.listener = listener;
  }

  /** Gives those of a class file to a listener. */
  static void of(byte[] bytes, Listener listener) {
    new ClassReader(bytes).accept(new References(listener), ClassReader.SKIP_DEBUG);
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
      case Type.OBJECT -> listener.type(type.getInternalName());
      default -> {
        // Primitive types are everywhere.
      }
    }
  }

  private void member(String owner, String member) {
    type(owner);
    // An array's clone() and length are the language's.
    if (!owner.startsWith("[")) {
      listener.member(owner, member);
    }
  }

  @Override
  public void visit(
      int version, int access, String name, String signature, String parent, String[] interfaces) {
    // Object alone has no parent, and D8 makes other classes of records.
    if (parent != null && !parent.equals("java/lang/Record")) {
      type(parent);
    }
    for (String each : interfaces) {
      type(each);
    }
  }

  @Override
  public @Nullable FieldVisitor visitField(
      int access, String name, String type, String signature, Object value) {
    type(Type.getType(type));
    return null;
  }

  @Override
  public MethodVisitor visitMethod(
      int access, String name, String type, String signature, String[] exceptions) {
    type(Type.getMethodType(type));
    return new Code();
  }

  private final class Code extends MethodVisitor {

    Code() {
      super(Opcodes.ASM9);
    }

    @Override
    public void visitMethodInsn(
        int opcode, String owner, String name, String type, boolean isInterface) {
      boolean isOfARecord = owner.equals("java/lang/Record");
      if (!isOfARecord) {
        member(owner, name + type);
        type(Type.getMethodType(type));
      }
    }

    @Override
    public void visitFieldInsn(int opcode, String owner, String name, String type) {
      member(owner, name + "#" + type);
    }

    @Override
    public void visitTypeInsn(int opcode, String type) {
      type(type);
    }

    @Override
    public void visitMultiANewArrayInsn(String type, int dimensions) {
      type(Type.getType(type));
    }

    @Override
    public void visitTryCatchBlock(Label start, Label end, Label handler, String type) {
      if (type != null) {
        type(type);
      }
    }

    @Override
    public void visitLdcInsn(Object value) {
      constant(value);
    }

    /** D8 replaces the bootstrap method, not what it is given. */
    @Override
    public void visitInvokeDynamicInsn(
        String name, String type, Handle bootstrap, Object... arguments) {
      type(Type.getMethodType(type));
      for (Object argument : arguments) {
        constant(argument);
      }
    }

    private void type(String name) {
      References.this.type(name);
    }

    private void type(Type type) {
      References.this.type(type);
    }

    private void constant(Object value) {
      if (value instanceof Type type) {
        type(type);
      } else if (value instanceof Handle handle) {
        String separator = handle.getDesc().startsWith("(") ? "" : "#";
        member(handle.getOwner(), handle.getName() + separator + handle.getDesc());
      }
    }
  }
}
