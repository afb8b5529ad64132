plugins {
    `java-library`
    id("maven-publish")
}

description = "The app for phones: an activity, and a service that runs one robot"

dependencies {
    implementation(project(":starl-core"))
    implementation(project(":starl-primitives"))
    implementation(project(":starl-android"))
    implementation(project(":starl-apps"))
    // Reads deployment files: its parser alone.
    implementation(libs.snakeyaml)
    // Android itself, for compiling and for Robolectric; a phone has its own.
    compileOnly(libs.android.all)
    testImplementation(libs.robolectric)
    // Robolectric's tests are JUnit 4's.
    testImplementation(libs.junit.vintage.engine)
    testImplementation(libs.archunit)
    implementation(libs.jspecify)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}
