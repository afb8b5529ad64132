package android.os;

/** Stands for Android's classes, which are not on the class path here. */
public final class Fixture {

  private Fixture() {}
}
