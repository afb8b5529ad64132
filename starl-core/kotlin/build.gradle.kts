plugins {
    `java-library`
    kotlin("jvm") version "2.3.0"
    id("maven-publish")
}

description = "Apps in Kotlin that suspend"

dependencies {
    api(project(":starl-core"))
    api(libs.kotlin.stdlib)
    implementation(libs.jspecify)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}

kotlin {
    compilerOptions {
        jvmTarget.set(org.jetbrains.kotlin.gradle.dsl.JvmTarget.JVM_21)
        allWarningsAsErrors.set(true)
        freeCompilerArgs.add("-Xjdk-release=21")
    }
}

java {
    targetCompatibility = JavaVersion.VERSION_21
}
