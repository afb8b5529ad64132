package org.starl.android.apk;

import com.googlecode.d2j.Method;
import com.googlecode.d2j.dex.Dex2jar;
import com.googlecode.d2j.dex.DexExceptionHandler;
import com.googlecode.d2j.node.DexMethodNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Enumeration;
import java.util.List;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/**
 * Classes that were made dex of as those of the APK are, and classes of it again: what a phone would
 * run, as far as a JVM can run it. Names have slashes and no ending.
 */
final class DexedCode {

  private final SortedMap<String, byte[]> classes = new TreeMap<>();
  private final SortedSet<String> interfaces = new TreeSet<>();

  private DexedCode() {}

  /**
   * @param compiled class files, by name with ending, as {@link Selection} gives them
   * @param folder where it may put files, empty
   */
  static DexedCode of(SortedMap<String, byte[]> compiled, Path folder)
      throws ApkException, IOException {
    Path android = ClassPath.file(System.getProperty("java.class.path"), "android-all-");
    Dexer.dex(compiled, android, Levels.MIN_SDK, folder);
    DexedCode code = new DexedCode();
    for (Path dex : dexFiles(folder)) {
      Path jar = folder.resolve(dex.getFileName() + ".jar");
      Untranslated untranslated = new Untranslated();
      Dex2jar.from(dex.toFile())
          .computeFrames(true)
          .skipDebug(false)
          .withExceptionHandler(untranslated)
          .to(jar);
      if (!untranslated.lines.isEmpty()) {
        throw new IOException("not brought back from dex: " + untranslated.lines);
      }
      code.read(jar);
    }
    code.mend();
    return code;
  }

  /** The class files. */
  SortedMap<String, byte[]> classes() {
    return Collections.unmodifiableSortedMap(classes);
  }

  private static List<Path> dexFiles(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.filter(file -> file.toString().endsWith(".dex")).sorted().toList();
    }
  }

  private void read(Path jar) throws IOException {
    try (ZipFile zip = new ZipFile(jar.toFile())) {
      for (Enumeration<? extends ZipEntry> all = zip.entries(); all.hasMoreElements(); ) {
        ZipEntry entry = all.nextElement();
        if (entry.getName().endsWith(".class")) {
          byte[] bytes = zip.getInputStream(entry).readAllBytes();
          ClassReader reader = new ClassReader(bytes);
          classes.put(reader.getClassName(), bytes);
          if ((reader.getAccess() & Opcodes.ACC_INTERFACE) != 0) {
            interfaces.add(reader.getClassName());
          }
        }
      }
    }
  }

  /**
   * Dex does not tell a call of an interface's static method from another, class files do, and the
   * translator takes all for the other.
   */
  private void mend() {
    classes.replaceAll((name, bytes) -> {
      ClassWriter mended = new ClassWriter(0);
      new ClassReader(bytes).accept(new Mending(mended), 0);
      return mended.toByteArray();
    });
  }

  private boolean isInterface(String name) {
    if (name.startsWith("[")) {
      return false;
    }
    return interfaces.contains(name) || (!classes.containsKey(name) && isInterfaceOfJava(name));
  }

  private static boolean isInterfaceOfJava(String name) {
    try {
      ClassLoader loader = DexedCode.class.getClassLoader();
      return Class.forName(name.replace('/', '.'), false, loader).isInterface();
    } catch (ClassNotFoundException | NoClassDefFoundError e) {
      // Android's own code, which is not executed here.
      return false;
    }
  }

  private final class Mending extends ClassVisitor {

    Mending(ClassVisitor next) {
      super(Opcodes.ASM9, next);
    }

    @Override
    public MethodVisitor visitMethod(
        int access, String name, String descriptor, String signature, String[] exceptions) {
      MethodVisitor next = super.visitMethod(access, name, descriptor, signature, exceptions);
      return new MethodVisitor(Opcodes.ASM9, next) {
        @Override
        public void visitMethodInsn(
            int opcode, String owner, String method, String type, boolean wasInterface) {
          super.visitMethodInsn(opcode, owner, method, type, isInterface(owner));
        }
      };
    }
  }

  private static final class Untranslated implements DexExceptionHandler {
    private final List<String> lines = new ArrayList<>();

    @Override
    public void handleFileException(Exception e) {
      lines.add(String.valueOf(e));
    }

    @Override
    public void handleMethodTranslateException(
        Method method, DexMethodNode node, MethodVisitor visitor, Exception e) {
      lines.add(method + ": " + e);
    }
  }
}
